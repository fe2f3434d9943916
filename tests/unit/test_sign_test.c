/* The sequential sign test: its rules, and its error rate against the formula. */
#include "bench/measure/sign_test.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void nine_in_front_decide(void **state)
{
    (void)state;
    struct sign_test slow = {.bound = 2}, fast = {.bound = 2};
    for (int i = 0; i < 8; i++) {
        assert_int_equal(sign_test_add(&slow, 3), SIGN_OPEN);
        assert_int_equal(sign_test_add(&fast, 2), SIGN_OPEN); /* equal is not above */
    }
    assert_int_equal(sign_test_add(&slow, 3), SIGN_ABOVE);
    assert_int_equal(sign_test_add(&fast, 1), SIGN_WITHIN);
    assert_int_equal(sign_test_add(&slow, 1), SIGN_ABOVE); /* stays decided */
    assert_int_equal(slow.above, 9);
    assert_int_equal(slow.below, 0);
}

static void no_winner_is_inconclusive(void **state)
{
    (void)state;
    struct sign_test test = {.bound = 2};
    for (int i = 0; i < SIGN_TEST_PAIRS_MAX - 1; i++)
        assert_int_equal(sign_test_add(&test, i % 2 ? 1 : 3), SIGN_OPEN);
    assert_int_equal(sign_test_add(&test, 1), SIGN_INCONCLUSIVE);
    assert_int_equal(sign_test_decision(&test), SIGN_INCONCLUSIVE);
}

static void useless_ratios_weigh_nothing_and_end(void **state)
{
    (void)state;
    const double useless[] = {NAN, INFINITY, -INFINITY, 0, -1};
    struct sign_test test = {.bound = 2};
    for (int i = 0; i < SIGN_TEST_PAIRS_MAX - 1; i++)
        assert_int_equal(sign_test_add(&test, useless[i % 5]), SIGN_OPEN);
    assert_int_equal(sign_test_add(&test, NAN), SIGN_INCONCLUSIVE);
    assert_int_equal(test.above + test.below, 0);
    assert_int_equal(test.lost, SIGN_TEST_PAIRS_MAX);
}

static double random_unit(uint64_t *state)
{
    *state = *state * 6364136223846793005U + 1442695040888963407U;
    return (double)(*state >> 11) / 9007199254740992.0;
}

struct tally {
    int wrong, inconclusive;
    double mean_pairs;
};

/* Tests of a submission within the bound whose pairs fall on the wrong side with probability p. */
static struct tally simulate(double p, int tests)
{
    struct tally tally = {0};
    uint64_t random = 11;
    for (int i = 0; i < tests; i++) {
        struct sign_test test = {.bound = 2};
        enum sign_decision decision = SIGN_OPEN;
        while (decision == SIGN_OPEN)
            decision = sign_test_add(&test, random_unit(&random) < p ? 2.5 : 1.5);
        tally.wrong += decision == SIGN_ABOVE;
        tally.inconclusive += decision == SIGN_INCONCLUSIVE;
        tally.mean_pairs += (double)(test.above + test.below) / tests;
    }
    return tally;
}

static void errors_follow_the_formula(void **state)
{
    (void)state;
    enum { TESTS = 100000 };
    struct tally tally = simulate(0.1, TESTS);
    assert_int_equal(tally.wrong, 0);
    assert_int_equal(tally.inconclusive, 0);
    assert_true(fabs(tally.mean_pairs - 9 / 0.8) < 0.1); /* lead over drift */
    tally = simulate(0.3, TESTS);
    double expected = TESTS / (1 + pow(0.7 / 0.3, SIGN_TEST_LEAD)); /* the gambler's ruin */
    assert_true(fabs(tally.wrong - expected) < 4 * sqrt(expected));
    tally = simulate(0.5, 2000);
    assert_in_range(tally.inconclusive, 200, 1200);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nine_in_front_decide),
        cmocka_unit_test(no_winner_is_inconclusive),
        cmocka_unit_test(useless_ratios_weigh_nothing_and_end),
        cmocka_unit_test(errors_follow_the_formula),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
