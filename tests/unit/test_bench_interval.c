/* Medians and sign-test intervals: known inputs, known intervals; coverage by simulation. */
#include "bench/measure/interval.h"

#include "reference/base/random.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void near(double value, double expected)
{
    assert_true(fabs(value - expected) <= 1e-12 * fabs(expected));
}

static void median_is_the_middle(void **state)
{
    (void)state;
    const double odd[] = {5, 1, 4, 2, 3}, even[] = {8, 1, 2, 64};
    near(interval_of(odd, 5).median, 3);
    near(interval_of(even, 4).median, 4); /* geometric mean of 2 and 8 */
    near(interval_of(odd, 5).least, 1);
    assert_int_equal(interval_of(odd, 0).count, 0);
    near(interval_of(odd, 0).median + 1, 1);
}

/* The table of the sign test: how many values stay outside on each side, and the confidence. */
static void ends_are_those_of_the_sign_test(void **state)
{
    (void)state;
    static const struct {
        int count, rank;
        double confidence;
    } table[] = {{1, 0, 0},
                 {2, 0, 0.5},
                 {5, 0, 0.9375},
                 {6, 0, 0.96875},
                 {8, 0, 0.9921875},
                 {9, 1, 0.9609375},
                 {11, 1, 0.98828125},
                 {12, 2, 0.96142578125},
                 {20, 5, 0.9586105346679688},
                 {30, 9, 0.9572260547429323}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        double values[INTERVAL_VALUES_MAX];
        for (int k = 0; k < table[i].count; k++)
            values[k] = 1 + (k * 7) % table[i].count; /* 1 ... count, mixed; 7 divides no count */
        struct interval interval = interval_of(values, table[i].count);
        near(interval.low, 1 + table[i].rank);
        near(interval.high, table[i].count - table[i].rank);
        assert_true(fabs(interval.confidence - table[i].confidence) < 1e-8);
    }
}

static void ratios_turned_round_give_inverse_intervals(void **state)
{
    (void)state;
    double above[12], below[12];
    struct random rng;
    random_init(&rng, 3);
    for (int i = 0; i < 12; i++) {
        above[i] = 1 + random_real(&rng);
        below[i] = 1 + random_real(&rng);
    }
    struct interval there = interval_of_ratios(above, below, 12);
    struct interval back = interval_of_ratios(below, above, 12);
    near(there.median, 1 / back.median);
    near(there.low, 1 / back.high);
    near(there.high, 1 / back.low);
}

static void wide_intervals_are_too_noisy(void **state)
{
    (void)state;
    struct interval narrow = {.median = 2, .low = 1.7, .high = 2.4};
    struct interval high = {.median = 2, .low = 1.9, .high = 2.6};
    struct interval low = {.median = 2, .low = 1.5, .high = 2.1};
    assert_false(interval_too_noisy(&narrow));
    assert_true(interval_too_noisy(&high));
    assert_true(interval_too_noisy(&low));
}

/* Skewed noise, median 1: the interval of 12 must hold 1 in at least 95 % of trials, and be of use:
 * not in all of them. */
static void coverage_holds_on_skewed_noise(void **state)
{
    (void)state;
    enum { TRIALS = 4000 };
    int held = 0;
    struct random rng;
    random_init(&rng, 11);
    for (int trial = 0; trial < TRIALS; trial++) {
        double values[12];
        for (int i = 0; i < 12; i++) /* exponential, scaled to median 1 */
            values[i] = -log(1 - random_real(&rng)) / log(2) + 1e-9;
        struct interval interval = interval_of(values, 12);
        held += interval.low <= 1 && 1 <= interval.high;
    }
    assert_in_range(held, 0.95 * TRIALS, 0.975 * TRIALS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(median_is_the_middle),
        cmocka_unit_test(ends_are_those_of_the_sign_test),
        cmocka_unit_test(ratios_turned_round_give_inverse_intervals),
        cmocka_unit_test(wide_intervals_are_too_noisy),
        cmocka_unit_test(coverage_holds_on_skewed_noise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
