/* Keeping the first faults of a kind; see faults.h. */
#include "reference/survey/faults.h"

#include <stdlib.h>

static int by_numbers(const void *left, const void *right)
{
    const struct survey_element *a = left, *b = right;
    for (int i = 0; i < 4; i++)
        if (a->at[i] != b->at[i])
            return a->at[i] < b->at[i] ? -1 : 1;
    return 0;
}

void survey_sort(struct survey_fault *fault)
{
    if (fault->kept_count > 0)
        qsort(fault->kept, (size_t)fault->kept_count, sizeof *fault->kept, by_numbers);
    if (fault->kept_count > SURVEY_KEPT)
        fault->kept_count = SURVEY_KEPT;
}

/* There is room for twice as many as are kept; when it is full the later half is dropped. */
int survey_note(struct survey_fault *fault, struct survey_element element, struct error *err)
{
    if (!fault->kept)
        fault->kept = calloc(2 * (size_t)SURVEY_KEPT, sizeof *fault->kept);
    if (!fault->kept)
        return error_set(err, "out of memory: faults of a mesh");
    if (fault->kept_count == 2 * SURVEY_KEPT)
        survey_sort(fault);
    fault->count++;
    fault->kept[fault->kept_count++] = element;
    return 0;
}
