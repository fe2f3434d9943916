/* Sorting; see sorting.h. */
#include "graders/library/sorting.h"

#include <string.h>

enum { BYTE_VALUES = 256, WORD_BYTES = 8, SHORT_RUN = 8 };

/* ------------------------------------------------------------------------------------- by bytes */

/* One stable pass by the byte at `shift`. Returns whether anything could move. */
static int sort_by_byte(const uint64_t *from, uint64_t *to, int64_t count, int shift)
{
    int64_t start[BYTE_VALUES + 1] = {0};
    for (int64_t i = 0; i < count; i++)
        start[((from[i] >> shift) & 0xff) + 1]++;
    for (int value = 0; value < BYTE_VALUES; value++)
        if (start[value + 1] == count)
            return 0; /* all have the same byte here */
    for (int value = 0; value < BYTE_VALUES; value++)
        start[value + 1] += start[value];
    for (int64_t i = 0; i < count; i++)
        to[start[(from[i] >> shift) & 0xff]++] = from[i];
    return 1;
}

void sort_words(uint64_t *words, uint64_t *spare, int64_t count)
{
    uint64_t *from = words, *to = spare;
    if (count < 2)
        return;
    for (int byte = 0; byte < WORD_BYTES; byte++)
        if (sort_by_byte(from, to, count, 8 * byte)) {
            uint64_t *sorted = to;
            to = from;
            from = sorted;
        }
    if (from != words)
        memcpy(words, from, (size_t)count * sizeof *words);
}

/* --------------------------------------------------------------------------------- by comparison
 */

static void sort_short_run(int64_t *order, int64_t count, sort_comparison *compare,
                           const void *context)
{
    for (int64_t i = 1; i < count; i++) {
        int64_t thing = order[i], place = i;
        for (; place > 0 && compare(order[place - 1], thing, context) > 0; place--)
            order[place] = order[place - 1];
        order[place] = thing;
    }
}

static void merge_runs(const int64_t *left, int64_t left_count, const int64_t *right,
                       int64_t right_count, int64_t *to, sort_comparison *compare,
                       const void *context)
{
    while (left_count > 0 && right_count > 0) {
        if (compare(*left, *right, context) <= 0) {
            *to++ = *left++;
            left_count--;
        } else {
            *to++ = *right++;
            right_count--;
        }
    }
    if (left_count > 0)
        memcpy(to, left, (size_t)left_count * sizeof *to);
    if (right_count > 0)
        memcpy(to, right, (size_t)right_count * sizeof *to);
}

static int64_t smaller(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

void sort_order(int64_t *order, int64_t *spare, int64_t count, sort_comparison *compare,
                const void *context)
{
    for (int64_t first = 0; first < count; first += SHORT_RUN)
        sort_short_run(order + first, smaller(SHORT_RUN, count - first), compare, context);
    int64_t *from = order, *to = spare;
    for (int64_t run = SHORT_RUN; run < count; run *= 2) {
        for (int64_t first = 0; first < count; first += 2 * run) {
            int64_t left = smaller(run, count - first);
            int64_t right = smaller(run, count - first - left);
            merge_runs(from + first, left, from + first + left, right, to + first, compare,
                       context);
        }
        int64_t *sorted = to;
        to = from;
        from = sorted;
    }
    if (from != order)
        memcpy(order, from, (size_t)count * sizeof *order);
}
