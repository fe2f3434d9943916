/* Which allocations are refused? */
#include "graders/engine/run/sweep.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void few_are_all_refused(void **state)
{
    (void)state;
    int64_t chosen[SWEEP_MOST];
    for (int64_t allocations = 0; allocations <= SWEEP_MOST; allocations++) {
        assert_int_equal(sweep_choose(allocations, 5, chosen), allocations);
        for (int64_t i = 0; i < allocations; i++)
            assert_int_equal(chosen[i], i + 1);
    }
}

static void of_many_the_first_and_both_parities_of_the_rest(void **state)
{
    (void)state;
    static const int64_t counts[] = {SWEEP_MOST + 1, 32, 33, 64, 1000, 1001, INT64_C(1) << 40};
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++)
        for (uint64_t seed = 0; seed < 200; seed++) {
            int64_t chosen[SWEEP_MOST];
            int odd = 0;
            assert_int_equal(sweep_choose(counts[c], seed, chosen), SWEEP_MOST);
            for (int i = 0; i < SWEEP_MOST; i++) {
                assert_true(chosen[i] > (i > 0 ? chosen[i - 1] : 0) && chosen[i] <= counts[c]);
                assert_true(i >= SWEEP_FIRST || chosen[i] == i + 1);
                odd += i >= SWEEP_FIRST && chosen[i] % 2;
            }
            assert_true(odd > 1 && odd < SWEEP_FIRST - 1);
        }
}

static void every_one_can_be_drawn(void **state)
{
    (void)state;
    enum { COUNT = 40 };
    int seen[COUNT + 1] = {0};
    for (uint64_t seed = 0; seed < 500; seed++) {
        int64_t chosen[SWEEP_MOST];
        int count = sweep_choose(COUNT, seed, chosen);
        for (int i = 0; i < count; i++)
            seen[chosen[i]]++;
    }
    for (int i = 1; i <= COUNT; i++)
        assert_true(seen[i] > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(few_are_all_refused),
        cmocka_unit_test(of_many_the_first_and_both_parities_of_the_rest),
        cmocka_unit_test(every_one_can_be_drawn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
