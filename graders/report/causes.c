/* Counting causes; see causes.h. */
#include "graders/report/causes.h"

#include <stdlib.h>
#include <string.h>

static struct cause *find_or_add(struct causes *causes, const char *slug)
{
    for (size_t i = 0; i < causes->count; i++)
        if (strcmp(causes->list[i].slug, slug) == 0)
            return &causes->list[i];
    struct cause *list = realloc(causes->list, (causes->count + 1) * sizeof *list);
    if (!list)
        return NULL;
    causes->list = list;
    size_t columns = causes->student_count;
    bool *touched = realloc(causes->touched, (causes->count + 1) * columns * sizeof *touched);
    if (!touched)
        return NULL;
    causes->touched = touched;
    memset(touched + causes->count * columns, 0, columns * sizeof *touched);
    struct cause *added = &list[causes->count];
    *added = (struct cause){.slug = slug, .example = {"", ""}, .row = causes->count};
    causes->count++;
    return added;
}

/* Notes that `student` lost points by `slug`; `one` is the case that says so, or NULL. */
static int note(struct causes *causes, size_t student, const json_t *result, const char *slug,
                struct words message, const json_t *one)
{
    struct cause *cause = find_or_add(causes, slug);
    if (!cause)
        return -1;
    bool *touched = &causes->touched[cause->row * causes->student_count + student];
    cause->student_count += !*touched;
    *touched = true;
    if (!*cause->example.en) {
        cause->example = message;
        cause->result = result;
    }
    if (!cause->case_name && json_is_true(json_object_get(one, "scene"))) {
        cause->case_name = result_text(one, "name");
        cause->scene_result = result;
    }
    return 0;
}

static int note_result(struct causes *causes, size_t student, const json_t *result)
{
    size_t i;
    json_t *part;
    json_array_foreach(json_object_get(result, "cases"), i, part)
    {
        if (words_outcome(result_text(part, "verdict")) == OUTCOME_FAILED &&
            note(causes, student, result, result_text(part, "cause"), words_in(part, "message"),
                 part) != 0)
            return -1;
    }
    json_array_foreach(json_object_get(result, "checks"), i, part)
    {
        if (words_outcome(result_text(part, "verdict")) == OUTCOME_FAILED &&
            note(causes, student, result, result_text(part, "verdict"), words_in(part, "message"),
                 NULL) != 0)
            return -1;
    }
    if (strcmp(result_text(result, "verdict"), "compile-error") == 0)
        return note(causes, student, result, "compile-error", words_in(result, "summary"), NULL);
    return 0;
}

static int by_frequency(const void *a, const void *b)
{
    const struct cause *one = a;
    const struct cause *other = b;
    if (one->student_count != other->student_count)
        return one->student_count > other->student_count ? -1 : 1;
    return strcmp(one->slug, other->slug);
}

int causes_of(const struct gradebook *book, size_t exercise, struct causes *causes,
              struct error *err)
{
    *causes = (struct causes){.student_count = book->student_count};
    for (size_t s = 0; s < book->student_count; s++) {
        const json_t *result = book->students[s].results[exercise];
        if (!result)
            continue;
        causes->answer_count++;
        if (note_result(causes, s, result) != 0) {
            causes_release(causes);
            return error_set(err, "out of memory for the causes");
        }
    }
    if (causes->count > 0)
        qsort(causes->list, causes->count, sizeof *causes->list, by_frequency);
    return 0;
}

bool causes_touch(const struct causes *causes, const struct cause *cause, size_t student)
{
    return causes->touched[cause->row * causes->student_count + student];
}

void causes_release(struct causes *causes)
{
    free(causes->touched);
    free(causes->list);
    *causes = (struct causes){0};
}
