/* Seeded randomness and the points of a circle. */
#include "reference/base/random.h"
#include "reference/mesh/circle.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

static void splitmix_and_xoshiro_give_the_published_values(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 0);
    /* splitmix64's first outputs for seed 0, as its author publishes them */
    assert_true(rng.state[0] == 0xe220a8397b1dcdafu);
    assert_true(rng.state[1] == 0x6e789e6aa1b965f4u);
    assert_true(rng.state[2] == 0x06c45d188009454fu);
    assert_true(rng.state[3] == 0xf88bb8a8724c81ecu);
    /* xoshiro256** from state 1 2 3 4: the values of the Rust and C test vectors */
    rng = (struct random){{1, 2, 3, 4}};
    assert_true(random_next(&rng) == 11520u);
    assert_true(random_next(&rng) == 0u);
    assert_true(random_next(&rng) == 1509978240u);
    assert_true(random_next(&rng) == 1215971899390074240u);
}

static void below_is_even_over_its_range(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 7);
    int counts[6] = {0};
    for (int i = 0; i < 60000; i++) {
        uint64_t value = random_below(&rng, 6);
        assert_true(value < 6);
        counts[value]++;
    }
    for (int i = 0; i < 6; i++)
        assert_in_range(counts[i], 9600, 10400); /* standard deviation 91 */
    assert_true(random_below(&rng, 1) == 0);
    /* Three quarters of 2^64: without rejection the low third would be twice as likely. */
    const uint64_t bound = UINT64_C(3) << 62;
    int low = 0;
    for (int i = 0; i < 30000; i++)
        low += random_below(&rng, bound) < bound / 3;
    assert_in_range(low, 9600, 10400);
}

static void reals_stay_in_their_interval(void **state)
{
    (void)state;
    struct random rng;
    random_init(&rng, 8);
    double sum = 0.0;
    for (int i = 0; i < 10000; i++) {
        double x = random_real(&rng);
        assert_true(x >= 0.0 && x < 1.0);
        sum += x;
        float f = random_float(&rng, -2.0F, 3.0F);
        assert_true(f >= -2.0F && f <= 3.0F);
    }
    assert_true(fabs(sum / 10000 - 0.5) < 0.015);
}

static void permutations_are_permutations_and_differ(void **state)
{
    (void)state;
    int fixed_points = 0;
    for (uint64_t seed = 0; seed < 200; seed++) {
        struct random rng;
        random_init(&rng, seed);
        int32_t order[50];
        int seen[50] = {0};
        random_permutation(&rng, order, 50);
        for (int i = 0; i < 50; i++) {
            assert_in_range(order[i], 0, 49);
            seen[order[i]]++;
            fixed_points += order[i] == i;
        }
        for (int i = 0; i < 50; i++)
            assert_int_equal(seen[i], 1);
    }
    assert_in_range(fixed_points, 120, 290); /* one a permutation is expected */
    struct random rng;
    random_init(&rng, 1);
    random_permutation(&rng, NULL, 0);
}

static void circle_points_agree_with_the_c_library(void **state)
{
    (void)state;
    const double turn = 2.0 * acos(-1.0);
    for (int64_t steps = 1; steps < 300; steps++)
        for (int64_t step = -steps; step <= 2 * steps; step++) {
            struct circle_point p = circle_point(step, steps);
            double angle = turn * (double)step / (double)steps;
            assert_true(fabs(p.cosine - cos(angle)) < 3e-15);
            assert_true(fabs(p.sine - sin(angle)) < 3e-15);
        }
    struct circle_point quarter = circle_point(1, 4), half = circle_point(7, 14);
    assert_true(quarter.cosine == 0.0 && quarter.sine == 1.0);
    assert_true(half.cosine == -1.0 && half.sine == 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(splitmix_and_xoshiro_give_the_published_values),
        cmocka_unit_test(below_is_even_over_its_range),
        cmocka_unit_test(reals_stay_in_their_interval),
        cmocka_unit_test(permutations_are_permutations_and_differ),
        cmocka_unit_test(circle_points_agree_with_the_c_library),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
