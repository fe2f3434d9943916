/* Comparing sets of tuples; see tuples.h. */
#include "graders/library/tuples.h"

#include "graders/library/cycles.h"

#include <stdlib.h>

/* The smaller of a row and its reverse. */
static void point_forward(int32_t *row, int64_t length)
{
    for (int64_t i = 0, j = length - 1; i < j; i++, j--)
        if (row[i] != row[j]) {
            if (row[i] > row[j])
                cyclic_reverse(row, length);
            return;
        }
}

static void sort_values(int32_t *row, int64_t length)
{
    for (int64_t i = 1; i < length; i++) {
        int32_t value = row[i];
        int64_t place = i;
        for (; place > 0 && row[place - 1] > value; place--)
            row[place] = row[place - 1];
        row[place] = value;
    }
}

static void bring_into_form(int32_t *row, int64_t length, enum tuple_symmetry symmetry)
{
    switch (symmetry) {
    case TUPLES_EXACT:
        break;
    case TUPLES_REVERSED:
        point_forward(row, length);
        break;
    case TUPLES_ROTATED:
        cyclic_canonical(row, length);
        break;
    case TUPLES_ANY_ORDER:
        sort_values(row, length);
        break;
    }
}

static void reverse_cycle(int32_t *row, int64_t length)
{
    cyclic_reverse(row, length);
    cyclic_canonical(row, length);
}

/* Copies tuples behind those that are there already, each in its form. */
static void append_tuples(struct set_rows *to, int64_t at, const int32_t *from, int64_t count,
                          int width, enum tuple_symmetry symmetry)
{
    for (int64_t i = 0; i < count; i++) {
        int32_t *row = to->values + (at + i) * width;
        for (int64_t c = 0; c < width; c++)
            row[c] = from[i * width + c];
        bring_into_form(row, width, symmetry);
        to->first[at + i + 1] = (at + i + 1) * width;
    }
}

int tuples_compare(const int32_t *answer, int64_t answer_count, const int32_t *right,
                   int64_t right_count, int width, enum tuple_symmetry symmetry,
                   struct set_fault *fault, struct error *err)
{
    *fault = (struct set_fault){0};
    int64_t count, value_count;
    if (width < 1 || width > TUPLE_WIDTH_MOST)
        return error_set(err, "tuples of %d numbers: the width is 1 to %d", width,
                         TUPLE_WIDTH_MOST);
    if ((!answer && answer_count > 0) || (!right && right_count > 0))
        return error_set(err, "a table of tuples is NULL: look at that before comparing");
    if (__builtin_add_overflow(answer_count, right_count, &count) ||
        __builtin_mul_overflow(count, (int64_t)width, &value_count))
        return error_set(err, "too many tuples to compare: check the counts of the answer first");
    struct set_rows rows;
    if (set_rows_init(&rows, answer_count, right_count, value_count, err))
        return -1;
    append_tuples(&rows, 0, answer, answer_count, width, symmetry);
    append_tuples(&rows, answer_count, right, right_count, width, symmetry);
    int failed = set_rows_match(&rows,
                                symmetry == TUPLES_EXACT     ? cyclic_reverse
                                : symmetry == TUPLES_ROTATED ? reverse_cycle
                                                             : NULL,
                                fault, err);
    set_rows_release(&rows);
    return failed;
}
