/* Labels up to names: what is told, and random labels against all pairs. */
#include "graders/library/partition.h"
#include "reference/base/random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

enum { MOST = 10 };

static struct partition_fault compare(const int32_t *answer, const int32_t *right, int64_t count,
                                      int64_t label_count)
{
    struct partition_fault fault;
    assert_int_equal(partition_compare(answer, right, count, label_count, &fault, NULL), 0);
    return fault;
}

static void names_do_not_matter(void **state)
{
    (void)state;
    const int32_t right[] = {0, 0, 1, 2, 1, -1}, answer[] = {2, 2, 0, 1, 0, -1};
    struct partition_fault fault = compare(answer, right, 6, 3);
    assert_null(partition_fault_cause(&fault));
    assert_int_equal(fault.group_count, 3);
    partition_fault_release(&fault);
    const int32_t wide[] = {INT32_MAX, INT32_MAX, 5, 66000, 5, -1};
    fault = compare(wide, right, 6, PARTITION_ANY_NAMES);
    assert_null(partition_fault_cause(&fault));
    partition_fault_release(&fault);
    partition_fault_release(&fault);
    fault = compare(NULL, NULL, 0, 0);
    assert_null(partition_fault_cause(&fault));
    partition_fault_release(&fault);
}

static void each_kind_of_fault_is_told(void **state)
{
    (void)state;
    const int32_t right[] = {0, 0, 1, 1, 2, -1};
    const int32_t joined[] = {0, 0, 0, 0, 1, -1};
    struct partition_fault fault = compare(joined, right, 6, 3);
    assert_ptr_equal(partition_fault_cause(&fault), &partition_joined);
    assert_int_equal(fault.joined, 2);
    assert_int_equal(fault.joined_with, 0);
    assert_int_equal(fault.joined_count, 2);
    assert_int_equal(fault.gap, 2);
    partition_fault_release(&fault);
    const int32_t apart[] = {0, 0, 1, 2, 3, -1};
    fault = compare(apart, right, 6, 4);
    assert_ptr_equal(partition_fault_cause(&fault), &partition_apart);
    assert_int_equal(fault.apart, 3);
    assert_int_equal(fault.apart_from, 2);
    assert_int_equal(fault.marks[3], PARTITION_APART);
    partition_fault_release(&fault);
    const int32_t others[] = {0, INT32_MIN, 3, -1, 1, 2};
    fault = compare(others, right, 6, 3);
    assert_ptr_equal(partition_fault_cause(&fault), &partition_out_of_range);
    assert_int_equal(fault.out_of_range, 1);
    assert_int_equal(fault.out_of_range_count, 2);
    assert_int_equal(fault.unlabelled, 3);
    assert_int_equal(fault.labelled, 5);
    partition_fault_release(&fault);
    const int32_t gap[] = {0, 0, 3, 3, 1, -1};
    fault = compare(gap, right, 6, 5);
    assert_ptr_equal(partition_fault_cause(&fault), &partition_gap);
    assert_int_equal(fault.gap, 2);
    assert_int_equal(fault.gap_count, 2);
    partition_fault_release(&fault);
}

static void impossible_arguments_are_our_error(void **state)
{
    (void)state;
    const int32_t label = 0;
    struct partition_fault fault;
    struct error err = {0};
    assert_int_equal(partition_compare(&label, &label, -1, 1, &fault, &err), -1);
    assert_int_equal(partition_compare(NULL, &label, 1, 1, &fault, NULL), -1);
    assert_int_equal(partition_compare(&label, &label, INT64_MAX, 1, &fault, NULL), -1);
}

/* A claimed number of labels may be anything. */
static void a_wild_number_of_labels_costs_nothing(void **state)
{
    (void)state;
    const int32_t label[] = {0, 1};
    struct partition_fault fault = compare(label, label, 2, INT64_MAX);
    assert_int_equal(fault.gap, 2);
    assert_int_equal(fault.gap_count, INT64_MAX - 2);
    partition_fault_release(&fault);
}

/* ------------------------------------------------------------------------------ the slow oracle */

static uint8_t single_mark(int32_t answer, int32_t right, int64_t label_count)
{
    if (answer < -1 || (label_count >= 0 && answer >= label_count))
        return PARTITION_OUT_OF_RANGE;
    if (right >= 0 && answer < 0)
        return PARTITION_UNLABELLED;
    return right < 0 && answer >= 0 ? PARTITION_LABELLED : PARTITION_FINE;
}

/* The first thing that disagrees with an earlier one, and the first of these. */
static void find_pair(const int32_t *same, const int32_t *differing, const uint8_t *marks,
                      int count, int64_t *earlier, int64_t *first)
{
    *earlier = *first = -1;
    for (int j = 0; j < count && *first < 0; j++)
        for (int i = 0; i < j; i++)
            if (!marks[i] && !marks[j] && same[i] >= 0 && same[i] == same[j] &&
                differing[i] != differing[j]) {
                *earlier = i;
                *first = j;
                break;
            }
}

static int64_t smallest_gap(const int32_t *answer, const uint8_t *marks, int count,
                            int64_t label_count)
{
    for (int32_t label = 0; label < label_count; label++) {
        int i = 0;
        while (i < count && (marks[i] || answer[i] != label))
            i++;
        if (i == count)
            return label;
    }
    return -1;
}

static void random_labels_are_told_as_slowly(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 31);
    for (int trial = 0; trial < 50000; trial++) {
        int32_t answer[MOST], right[MOST];
        uint8_t marks[MOST];
        int count = (int)random_below(&rng, MOST + 1);
        uint64_t groups = 1 + random_below(&rng, 5);
        int64_t label_count = (int64_t)random_below(&rng, 6) - 1;
        for (int i = 0; i < count; i++) {
            right[i] = (int32_t)random_below(&rng, groups) - (random_below(&rng, 8) == 0);
            answer[i] = random_below(&rng, 4) ? (right[i] < 0 ? -1 : (right[i] + 1) % 5)
                                              : (int32_t)random_below(&rng, 7) - 2;
            marks[i] = single_mark(answer[i], right[i], label_count);
        }
        struct partition_fault fault = compare(answer, right, count, label_count);
        int64_t earlier, first;
        find_pair(answer, right, marks, count, &earlier, &first);
        assert_int_equal(fault.joined, first);
        assert_int_equal(fault.joined_with, earlier);
        find_pair(right, answer, marks, count, &earlier, &first);
        assert_int_equal(fault.apart, first);
        assert_int_equal(fault.apart_from, earlier);
        assert_int_equal(fault.gap, smallest_gap(answer, marks, count, label_count));
        for (int i = 0; i < count; i++)
            if (marks[i])
                assert_int_equal(fault.marks[i], marks[i]);
            else
                assert_true(fault.marks[i] == PARTITION_FINE || fault.marks[i] >= PARTITION_JOINED);
        partition_fault_release(&fault);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_do_not_matter),
        cmocka_unit_test(each_kind_of_fault_is_told),
        cmocka_unit_test(impossible_arguments_are_our_error),
        cmocka_unit_test(a_wild_number_of_labels_costs_nothing),
        cmocka_unit_test(random_labels_are_told_as_slowly),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
