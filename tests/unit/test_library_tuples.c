/* Sets of tuples: what is told, and random tables against a slow comparison. */
#include "graders/library/tuples.h"
#include "reference/base/random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST_ROWS = 12, MOST_WIDTH = 4 };

static void what_is_wrong_with_edges_is_told(void **state)
{
    (void)state;
    const int32_t right[] = {0, 1, 1, 2, 2, 0, 3, 4};
    const int32_t answer[] = {1, 0, 2, 1, 0, 1, 7, -5, 1, 2};
    struct set_fault fault;
    assert_int_equal(tuples_compare(answer, 5, right, 4, 2, TUPLES_ANY_ORDER, &fault, NULL), 0);
    assert_int_equal(fault.missing, 2);
    assert_int_equal(fault.missing_count, 2);
    assert_int_equal(fault.extra, 3);
    assert_int_equal(fault.extra_count, 1);
    assert_int_equal(fault.repeated, 2);
    assert_int_equal(fault.repeated_of, 0);
    assert_int_equal(fault.repeated_count, 2);
    const uint8_t entries[] = {SET_FINE, SET_FINE, SET_REPEATED, SET_EXTRA, SET_REPEATED};
    const uint8_t rights[] = {SET_FINE, SET_FINE, SET_MISSING, SET_MISSING};
    assert_memory_equal(fault.entry_marks, entries, sizeof entries);
    assert_memory_equal(fault.right_marks, rights, sizeof rights);
    assert_ptr_equal(set_fault_cause(&fault), &set_repeated);
    set_fault_release(&fault);
    set_fault_release(&fault);
}

static void a_flipped_triangle_is_neither_extra_nor_missing(void **state)
{
    (void)state;
    const int32_t right[] = {0, 1, 2, 2, 1, 3};
    const int32_t answer[] = {1, 2, 0, 1, 2, 3};
    struct set_fault fault;
    assert_int_equal(tuples_compare(answer, 2, right, 2, 3, TUPLES_ROTATED, &fault, NULL), 0);
    assert_int_equal(fault.reversed, 1);
    assert_int_equal(fault.reversed_right, 1);
    assert_int_equal(fault.reversed_count, 1);
    assert_int_equal(fault.missing_count + fault.extra_count + fault.repeated_count, 0);
    assert_ptr_equal(set_fault_cause(&fault), &set_reversed);
    set_fault_release(&fault);
    assert_int_equal(tuples_compare(answer, 2, right, 2, 3, TUPLES_ANY_ORDER, &fault, NULL), 0);
    assert_false(set_fault_found(&fault));
    set_fault_release(&fault);
}

static void nothing_equals_nothing(void **state)
{
    (void)state;
    struct set_fault fault;
    assert_int_equal(tuples_compare(NULL, 0, NULL, 0, 2, TUPLES_EXACT, &fault, NULL), 0);
    assert_false(set_fault_found(&fault));
    assert_int_equal(fault.missing, -1);
    set_fault_release(&fault);
}

static void impossible_arguments_are_our_error(void **state)
{
    (void)state;
    const int32_t row[] = {1, 2};
    struct set_fault fault;
    struct error err = {0};
    assert_int_equal(tuples_compare(row, -1, row, 1, 2, TUPLES_EXACT, &fault, &err), -1);
    assert_non_null(strstr(err.text, "check the counts of the answer first"));
    assert_int_equal(tuples_compare(NULL, 1, row, 1, 2, TUPLES_EXACT, &fault, NULL), -1);
    assert_int_equal(tuples_compare(row, INT64_MAX, row, 1, 2, TUPLES_EXACT, &fault, NULL), -1);
    assert_int_equal(tuples_compare(row, 1, row, 1, 0, TUPLES_EXACT, &fault, NULL), -1);
    assert_int_equal(
        tuples_compare(row, 1, row, 1, TUPLE_WIDTH_MOST + 1, TUPLES_EXACT, &fault, NULL), -1);
    set_fault_release(&fault);
}

/* ------------------------------------------------------------------------------ the slow oracle */

static bool same_in_order(const int32_t *a, const int32_t *b, int width, int shift, bool backwards)
{
    for (int i = 0; i < width; i++) {
        int at = (shift + (backwards ? width - 1 - i : i)) % width;
        if (a[i] != b[at])
            return false;
    }
    return true;
}

static bool same_numbers(const int32_t *a, const int32_t *b, int width)
{
    bool used[MOST_WIDTH] = {0};
    for (int i = 0; i < width; i++) {
        int j = 0;
        while (j < width && (used[j] || a[i] != b[j]))
            j++;
        if (j == width)
            return false;
        used[j] = true;
    }
    return true;
}

static bool same(const int32_t *a, const int32_t *b, int width, enum tuple_symmetry symmetry,
                 bool backwards)
{
    if (symmetry == TUPLES_ANY_ORDER)
        return same_numbers(a, b, width);
    if (symmetry == TUPLES_REVERSED)
        return same_in_order(a, b, width, 0, false) || same_in_order(a, b, width, 0, true);
    for (int shift = 0; shift < (symmetry == TUPLES_ROTATED ? width : 1); shift++)
        if (same_in_order(a, b, width, shift, backwards))
            return true;
    return false;
}

struct tables {
    int32_t answer[MOST_ROWS * MOST_WIDTH], right[MOST_ROWS * MOST_WIDTH];
    int answer_count, right_count, width;
    enum tuple_symmetry symmetry;
    uint8_t entry_marks[MOST_ROWS], right_marks[MOST_ROWS];
};

/* The first right row that has the mark and is the same; -1: none. */
static int find_right(const struct tables *t, int entry, bool backwards, int mark)
{
    for (int r = 0; r < t->right_count; r++)
        if ((mark < 0 || t->right_marks[r] == mark) &&
            same(t->answer + entry * t->width, t->right + r * t->width, t->width, t->symmetry,
                 backwards))
            return r;
    return -1;
}

static void mark_slowly(struct tables *t)
{
    memset(t->right_marks, SET_MISSING, sizeof t->right_marks);
    for (int i = 0; i < t->answer_count; i++) {
        int r = find_right(t, i, false, SET_MISSING);
        if (r >= 0)
            t->right_marks[r] = SET_FINE;
        bool is_known = find_right(t, i, false, -1) >= 0;
        t->entry_marks[i] = r >= 0 ? SET_FINE : is_known ? SET_REPEATED : SET_EXTRA;
    }
    if (t->symmetry == TUPLES_REVERSED || t->symmetry == TUPLES_ANY_ORDER)
        return;
    for (int i = 0; i < t->answer_count; i++) {
        int r = t->entry_marks[i] == SET_EXTRA ? find_right(t, i, true, SET_MISSING) : -1;
        if (r >= 0)
            t->entry_marks[i] = t->right_marks[r] = SET_REVERSED;
    }
}

static int count_of(const uint8_t *marks, int count, int mark, int64_t *first)
{
    int found = 0;
    *first = -1;
    for (int i = 0; i < count; i++)
        if (marks[i] == mark && found++ == 0)
            *first = i;
    return found;
}

static void assert_told(const struct tables *t, const struct set_fault *fault)
{
    int64_t first;
    assert_memory_equal(fault->entry_marks, t->entry_marks, (size_t)t->answer_count);
    assert_memory_equal(fault->right_marks, t->right_marks, (size_t)t->right_count);
    assert_int_equal(fault->missing_count,
                     count_of(t->right_marks, t->right_count, SET_MISSING, &first));
    assert_int_equal(fault->missing, first);
    assert_int_equal(fault->extra_count,
                     count_of(t->entry_marks, t->answer_count, SET_EXTRA, &first));
    assert_int_equal(fault->extra, first);
    assert_int_equal(fault->repeated_count,
                     count_of(t->entry_marks, t->answer_count, SET_REPEATED, &first));
    assert_int_equal(fault->repeated, first);
    assert_int_equal(fault->reversed_count,
                     count_of(t->entry_marks, t->answer_count, SET_REVERSED, &first));
    assert_int_equal(fault->reversed, first);
    if (fault->repeated >= 0) {
        int earlier = 0;
        while (!same(t->answer + earlier * t->width, t->answer + fault->repeated * t->width,
                     t->width, t->symmetry, false))
            earlier++;
        assert_int_equal(fault->repeated_of, earlier);
    }
    if (fault->reversed >= 0)
        assert_true(same(t->answer + fault->reversed * t->width,
                         t->right + fault->reversed_right * t->width, t->width, t->symmetry, true));
}

static void random_tables_are_told_as_slowly(void **state)
{
    (void)state;
    static const int32_t wild[] = {INT32_MIN, INT32_MAX, -1, 0, 1, 65536};
    struct random rng;
    random_init(&rng, 11);
    for (int trial = 0; trial < 20000; trial++) {
        struct tables t = {.width = 1 + (int)random_below(&rng, MOST_WIDTH),
                           .symmetry = (enum tuple_symmetry)random_below(&rng, 4),
                           .answer_count = (int)random_below(&rng, MOST_ROWS + 1),
                           .right_count = (int)random_below(&rng, MOST_ROWS + 1)};
        uint64_t values = 1 + random_below(&rng, 4);
        bool is_wild = random_below(&rng, 4) == 0;
        for (int i = 0; i < MOST_ROWS * MOST_WIDTH; i++) {
            t.answer[i] = (int32_t)random_below(&rng, values);
            t.right[i] = (int32_t)random_below(&rng, values);
            if (is_wild) {
                t.answer[i] = wild[t.answer[i]];
                t.right[i] = wild[t.right[i]];
            }
        }
        mark_slowly(&t);
        struct set_fault fault;
        assert_int_equal(tuples_compare(t.answer, t.answer_count, t.right, t.right_count, t.width,
                                        t.symmetry, &fault, NULL),
                         0);
        assert_told(&t, &fault);
        set_fault_release(&fault);
    }
}

static void a_large_permuted_table_is_right(void **state)
{
    (void)state;
    enum { COUNT = 100000 };
    struct random rng;
    random_init(&rng, 12);
    int32_t *right = malloc(3 * COUNT * sizeof *right), *answer = malloc(3 * COUNT * sizeof *right);
    int32_t *order = malloc(COUNT * sizeof *order);
    assert_true(right && answer && order);
    for (int i = 0; i < 3 * COUNT; i++)
        right[i] = (int32_t)random_next(&rng);
    random_permutation(&rng, order, COUNT);
    for (int i = 0; i < COUNT; i++)
        for (int c = 0; c < 3; c++)
            answer[3 * i + c] = right[3 * order[i] + (c + i) % 3];
    struct set_fault fault;
    assert_int_equal(tuples_compare(answer, COUNT, right, COUNT, 3, TUPLES_ROTATED, &fault, NULL),
                     0);
    assert_false(set_fault_found(&fault));
    set_fault_release(&fault);
    answer[3 * 777] ^= 1;
    assert_int_equal(tuples_compare(answer, COUNT, right, COUNT, 3, TUPLES_ROTATED, &fault, NULL),
                     0);
    assert_int_equal(fault.extra, 777);
    assert_int_equal(fault.missing, order[777]);
    assert_int_equal(fault.extra_count + fault.missing_count, 2);
    set_fault_release(&fault);
    free(right);
    free(answer);
    free(order);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_wrong_with_edges_is_told),
        cmocka_unit_test(a_flipped_triangle_is_neither_extra_nor_missing),
        cmocka_unit_test(nothing_equals_nothing),
        cmocka_unit_test(impossible_arguments_are_our_error),
        cmocka_unit_test(random_tables_are_told_as_slowly),
        cmocka_unit_test(a_large_permuted_table_is_right),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
