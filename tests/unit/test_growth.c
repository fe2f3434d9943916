/* The growth fit: every class, hidden quadratic terms, noise, tables that double. */
#include "bench/measure/growth.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

#include <cmocka.h>

enum { SIZES = 9, FIRST_ROUND = 7, FIRST_LOOK = 5 };

/* ---------------------------------------------------------------- counts to fit */

/* What a kernel over n triangles counts; `k` is its free parameter. */
typedef double count_function(double n, double k);

static double constant_work(double n, double k)
{
    (void)n;
    return k;
}

static double linear_work(double n, double k)
{
    return k * n + 40;
}

static double sorting_work(double n, double k)
{
    double half_edges = 3 * n;
    return k * half_edges * log2(half_edges) + 30 * half_edges;
}

static double n_sqrt_n_work(double n, double k)
{
    return k * n * sqrt(n) + 10 * n;
}

static double quadratic_work(double n, double k)
{
    return k * n * n + 10 * n;
}

static double cubic_work(double n, double k)
{
    return k * n * n * n + 10 * n;
}

/* A sort, then a scan over 1/k of all pairs at 4 instructions a pair. */
static double hidden_quadratic_work(double n, double k)
{
    return sorting_work(n, 20) + 4 * n * n / k;
}

static void measure(count_function *work, double k, int64_t first, int64_t sizes[SIZES],
                    int64_t counts[SIZES])
{
    for (int i = 0; i < SIZES; i++) {
        sizes[i] = first << i;
        counts[i] = (int64_t)work((double)sizes[i], k);
    }
}

/* Of the first seven sizes leaves the first four and the last. */
static void leap(int64_t sizes[SIZES], int64_t counts[SIZES])
{
    sizes[FIRST_LOOK - 1] = sizes[FIRST_ROUND - 1];
    counts[FIRST_LOOK - 1] = counts[FIRST_ROUND - 1];
}

static struct growth_fit fit_of(count_function *work, double k, int64_t first,
                                enum growth_class allowed, int count)
{
    int64_t sizes[SIZES], counts[SIZES];
    struct growth_fit fit;
    struct error err = {0};
    measure(work, k, first, sizes, counts);
    enum growth_look look = count < FIRST_ROUND   ? GROWTH_FIRST_LOOK
                            : count > FIRST_ROUND ? GROWTH_LAST_LOOK
                                                  : GROWTH_FULL_LOOK;
    if (look == GROWTH_FIRST_LOOK)
        leap(sizes, counts);
    assert_int_equal(growth_fit(sizes, counts, count, allowed, look, &fit, &err), 0);
    double sum = 0;
    for (int c = 0; c < GROWTH_CLASS_COUNT; c++)
        sum += fit.share[c];
    assert_true(fabs(sum - 1) < 1e-9);
    return fit;
}

/* ---------------------------------------------------------------- tests */

static void names_are_those_of_the_manifest(void **state)
{
    (void)state;
    const char *const names[] = {"1", "n", "n lg n", "n^1.5", "n^2"};
    for (int i = 0; i < 5; i++) {
        enum growth_class class;
        assert_int_equal(growth_class_find(names[i], &class), 0);
        assert_int_equal(class, i);
        assert_string_equal(growth_class_name(class), names[i]);
    }
    enum growth_class class;
    assert_int_equal(growth_class_find("n^3", &class), -1);
    assert_int_equal(growth_class_find("", &class), -1);
}

static void each_class_is_found_and_bounded(void **state)
{
    (void)state;
    const struct {
        count_function *work;
        double k;
        enum growth_class class;
        double exponent;
    } kernels[] = {
        {constant_work, 300, GROWTH_CONSTANT, 0}, {linear_work, 120, GROWTH_N, 1},
        {sorting_work, 20, GROWTH_N_LG_N, 1.1},   {n_sqrt_n_work, 20, GROWTH_N_SQRT_N, 1.5},
        {quadratic_work, 3, GROWTH_N_SQUARED, 2}, {cubic_work, 1, GROWTH_N_CUBED, 3}};
    for (int i = 0; i < 6; i++)
        for (int allowed = GROWTH_CONSTANT; allowed <= GROWTH_N_SQUARED; allowed++) {
            struct growth_fit fit =
                fit_of(kernels[i].work, kernels[i].k, 128, (enum growth_class)allowed, SIZES);
            int bound = allowed == GROWTH_N ? GROWTH_N_LG_N : allowed;
            bool within = (int)kernels[i].class <= bound;
            assert_int_equal(fit.decision, within ? GROWTH_PASS : GROWTH_FAIL);
            assert_true(fabs(fit.exponent - kernels[i].exponent) < 0.02);
            bool offered = kernels[i].class < GROWTH_N_CUBED || allowed == GROWTH_N_SQUARED;
            assert_int_equal(fit.class, offered ? kernels[i].class : GROWTH_N_SQUARED);
        }
}

static void coefficients_come_back(void **state)
{
    (void)state;
    struct growth_fit fit = fit_of(hidden_quadratic_work, 64, 128, GROWTH_N_LG_N, FIRST_ROUND);
    assert_true(fabs(fit.coefficient[GROWTH_N_SQUARED] - 4.0 / 64) < 1e-3);
    assert_true(fabs(fit.coefficient[GROWTH_N_LG_N] - 60) < 0.5);
    assert_true(fit.residual < 1e-4);
}

/* The table in growth.h. */
static void hidden_quadratics_are_found(void **state)
{
    (void)state;
    const struct {
        int64_t first;
        double k, share;
    } rows[] = {{128, 16, 0.68}, {128, 32, 0.515}, {128, 64, 0.35}, {128, 256, 0.12},
                {256, 16, 0.80}, {256, 32, 0.67},  {256, 64, 0.50}, {256, 256, 0.20}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct growth_fit fit =
            fit_of(hidden_quadratic_work, rows[i].k, rows[i].first, GROWTH_N_LG_N, FIRST_ROUND);
        assert_int_equal(fit.decision, GROWTH_UNDECIDED); /* two more sizes are the evidence */
        assert_true(fabs(fit.excess - rows[i].share) < 0.006);
        assert_int_equal(fit.class, GROWTH_N_SQUARED);
        fit = fit_of(hidden_quadratic_work, rows[i].k, rows[i].first, GROWTH_N_LG_N, SIZES);
        assert_int_equal(fit.decision, GROWTH_FAIL);
    }
}

/* Five of seven sizes pass what is clearly right, and leave everything else to all seven. */
static void a_first_look_passes_only_what_is_clear(void **state)
{
    (void)state;
    static const struct {
        count_function *work;
        double k;
        enum growth_decision decision;
    } rows[] = {
        {linear_work, 12, GROWTH_PASS},
        {sorting_work, 20, GROWTH_PASS},
        {n_sqrt_n_work, 1, GROWTH_UNDECIDED},
        {quadratic_work, 1, GROWTH_UNDECIDED},
        {hidden_quadratic_work, 16, GROWTH_UNDECIDED},
        {hidden_quadratic_work, 64, GROWTH_UNDECIDED},
        {hidden_quadratic_work, 256, GROWTH_UNDECIDED},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct growth_fit fit = fit_of(rows[i].work, rows[i].k, 128, GROWTH_N, FIRST_LOOK);
        assert_int_equal(fit.decision, rows[i].decision);
    }
}

/* What passes at first has so little above the bound that all seven pass it too. */
static void a_first_look_agrees_with_the_full_one(void **state)
{
    (void)state;
    for (double k = 16; k <= 1 << 20; k *= 1.1) {
        struct growth_fit first = fit_of(hidden_quadratic_work, k, 128, GROWTH_N, FIRST_LOOK);
        struct growth_fit full = fit_of(hidden_quadratic_work, k, 128, GROWTH_N, FIRST_ROUND);
        if (first.decision == GROWTH_PASS)
            assert_int_equal(full.decision, GROWTH_PASS);
    }
}

/* A table that grows by four out of step with the sizes: nothing is clear. */
static void a_first_look_does_not_pass_what_jumps(void **state)
{
    (void)state;
    int64_t sizes[SIZES], counts[SIZES];
    struct growth_fit fit;
    measure(linear_work, 12, 128, sizes, counts);
    for (int i = 0; i < SIZES; i += 2)
        counts[i] = counts[i] * 5 / 4;
    leap(sizes, counts);
    assert_int_equal(growth_fit(sizes, counts, FIRST_LOOK, GROWTH_N, GROWTH_FIRST_LOOK, &fit, NULL),
                     0);
    assert_true(fit.residual > 0.05);
    assert_int_equal(fit.decision, GROWTH_UNDECIDED);
}

/* The last round decides at 15 %, and the label never contradicts the decision. */
static void the_last_round_decides(void **state)
{
    (void)state;
    struct growth_fit fit = fit_of(hidden_quadratic_work, 1024, 128, GROWTH_N_LG_N, FIRST_ROUND);
    assert_int_equal(fit.decision, GROWTH_PASS);
    fit = fit_of(hidden_quadratic_work, 1024, 128, GROWTH_N_LG_N, SIZES);
    assert_true(fit.excess > 0.10 && fit.excess < 0.15);
    assert_int_equal(fit.decision, GROWTH_PASS);
    assert_true(fit.class <= GROWTH_N_LG_N);
}

static void sizes_where_the_constant_dominates_are_dropped(void **state)
{
    (void)state;
    int64_t sizes[SIZES], counts[SIZES];
    struct growth_fit fit;
    measure(linear_work, 30, 128, sizes, counts);
    for (int i = 0; i < SIZES; i++)
        counts[i] += 5000;
    assert_int_equal(growth_fit(sizes, counts, FIRST_ROUND, GROWTH_N, GROWTH_FULL_LOOK, &fit, NULL),
                     0);
    assert_int_equal(fit.first_used, 3); /* 5040 is a fifth of the count just before 1024 */
    assert_int_equal(fit.decision, GROWTH_PASS);
    assert_int_equal(fit.class, GROWTH_N);
    counts[0] = counts[1] = counts[2] = counts[3] = counts[4] = 1000000;
    assert_int_equal(growth_fit(sizes, counts, FIRST_ROUND, GROWTH_N, GROWTH_FULL_LOOK, &fit, NULL),
                     0);
    assert_true(fit.first_used <= FIRST_ROUND - GROWTH_SIZES_MIN);
}

/* ---------------------------------------------------------------- noise */

static double random_unit(uint64_t *state)
{
    *state = *state * 6364136223846793005U + 1442695040888963407U;
    return (double)(*state >> 11) / 9007199254740992.0;
}

static double random_normal(uint64_t *state)
{
    double u = random_unit(state) + 1e-300;
    return sqrt(-2 * log(u)) * cos(2 * acos(-1) * random_unit(state));
}

/* How many of 1000 noisy measurements fail, both rounds together. */
static int failures_with_noise(count_function *work, double k, double deviation)
{
    uint64_t random = 20240601;
    int failures = 0;
    for (int trial = 0; trial < 1000; trial++) {
        int64_t sizes[SIZES], counts[SIZES];
        struct growth_fit fit;
        measure(work, k, 128, sizes, counts);
        for (int i = 0; i < SIZES; i++)
            counts[i] = (int64_t)((double)counts[i] * (1 + deviation * random_normal(&random)));
        assert_int_equal(
            growth_fit(sizes, counts, FIRST_ROUND, GROWTH_N, GROWTH_FULL_LOOK, &fit, NULL), 0);
        if (fit.decision == GROWTH_UNDECIDED)
            assert_int_equal(
                growth_fit(sizes, counts, SIZES, GROWTH_N, GROWTH_LAST_LOOK, &fit, NULL), 0);
        assert_int_not_equal(fit.decision, GROWTH_UNDECIDED);
        failures += fit.decision == GROWTH_FAIL;
    }
    return failures;
}

static void noise_fails_no_right_solution(void **state)
{
    (void)state;
    const double deviations[] = {0.003, 0.01};
    for (int i = 0; i < 2; i++) {
        assert_int_equal(failures_with_noise(linear_work, 300, deviations[i]), 0);
        assert_int_equal(failures_with_noise(sorting_work, 20, deviations[i]), 0);
        assert_int_equal(failures_with_noise(hidden_quadratic_work, 64, deviations[i]), 1000);
        assert_int_equal(failures_with_noise(n_sqrt_n_work, 20, deviations[i]), 1000);
    }
}

/* Hash tables that double at any load, whose zeroing costs from 1 % to half of all work, on meshes
 * that have not quite the asked size: the counts jump by up to a third. */
static void tables_that_double_pass(void **state)
{
    (void)state;
    uint64_t random = 7;
    int failures = 0, trials = 0;
    for (int zeroing = 2; zeroing <= 32; zeroing *= 2)
        for (int trial = 0; trial < 400; trial++, trials++) {
            int64_t sizes[SIZES], counts[SIZES];
            struct growth_fit fit;
            double load = 0.4 + 0.6 * random_unit(&random);
            for (int i = 0; i < SIZES; i++) {
                double wobble = 1 + 0.03 * (2 * random_unit(&random) - 1);
                sizes[i] = (int64_t)((double)(128 << i) * wobble);
                double work = 180 * (double)sizes[i], slots = 16;
                for (; slots * load < 1.5 * (double)sizes[i]; slots *= 2)
                    work += slots * zeroing;
                counts[i] = (int64_t)(work + slots * zeroing);
            }
            assert_int_equal(
                growth_fit(sizes, counts, FIRST_ROUND, GROWTH_N, GROWTH_FULL_LOOK, &fit, NULL), 0);
            if (fit.decision == GROWTH_UNDECIDED)
                assert_int_equal(
                    growth_fit(sizes, counts, SIZES, GROWTH_N, GROWTH_LAST_LOOK, &fit, NULL), 0);
            failures += fit.decision == GROWTH_FAIL;
        }
    assert_int_equal(trials, 2000);
    assert_int_equal(failures, 0);
}

/* What jumps at some sizes, and is linear before and behind: a radix sort that needs one more pass,
 * data that leave a cache, blocks that are larger from some size on. */
static void measure_steps(double k, const double height[2], const int place[2], double factor,
                          uint64_t *random, int64_t sizes[SIZES], int64_t counts[SIZES])
{
    for (int i = 0; i < SIZES; i++) {
        double n = factor * (double)(128 << i) * (0.985 + 0.03 * random_unit(random)), work;
        work = k > 0 ? sorting_work(n, k) : linear_work(n, 200);
        for (int step = 0; step < 2; step++)
            work *= i >= place[step] ? 1 + height[step] : 1;
        sizes[i] = (int64_t)n;
        counts[i] = (int64_t)(work * (1 + 0.003 * random_normal(random)));
    }
}

static enum growth_decision decide_both_rounds(const int64_t sizes[SIZES],
                                               const int64_t counts[SIZES])
{
    struct growth_fit fit;
    assert_int_equal(growth_fit(sizes, counts, FIRST_ROUND, GROWTH_N, GROWTH_FULL_LOOK, &fit, NULL),
                     0);
    if (fit.decision == GROWTH_UNDECIDED)
        assert_int_equal(growth_fit(sizes, counts, SIZES, GROWTH_N, GROWTH_LAST_LOOK, &fit, NULL),
                         0);
    return fit.decision;
}

static void steps_pass_wherever_they_are(void **state)
{
    (void)state;
    static const double heights[] = {0.05, 0.1, 0.2, 0.35, 0.5, 1};
    uint64_t random = 11;
    for (int kernel = 0; kernel < 2; kernel++)
        for (int h = 0; h < 36; h++)
            for (int first = 1; first < SIZES; first++)
                for (int second = first + 1; second <= SIZES; second++) {
                    int64_t sizes[SIZES], counts[SIZES];
                    const double height[] = {heights[h % 6], heights[h / 6]};
                    const int place[] = {first, second};
                    measure_steps(20 * kernel, height, place, 0.75 + random_unit(&random) * 0.75,
                                  &random, sizes, counts);
                    if (decide_both_rounds(sizes, counts) != GROWTH_PASS)
                        fail_msg("fails: steps of %.0f %% at %d and %.0f %% at %d", 100 * height[0],
                                 first, 100 * height[1], second);
                }
}

static void bad_arguments_are_errors(void **state)
{
    (void)state;
    const int64_t sizes[] = {128, 256, 512, 1024}, counts[] = {5, 6, 7, 8};
    const int64_t equal[] = {128, 256, 256, 1024}, zero[] = {5, 0, 7, 8};
    struct growth_fit fit;
    struct error err = {0};
    assert_int_equal(growth_fit(sizes, counts, 3, GROWTH_N, GROWTH_FULL_LOOK, &fit, &err), -1);
    assert_string_not_equal(err.text, "");
    assert_int_equal(growth_fit(sizes, counts, 25, GROWTH_N, GROWTH_FULL_LOOK, &fit, NULL), -1);
    assert_int_equal(growth_fit(equal, counts, 4, GROWTH_N, GROWTH_FULL_LOOK, &fit, NULL), -1);
    assert_int_equal(growth_fit(sizes, zero, 4, GROWTH_N, GROWTH_FULL_LOOK, &fit, NULL), -1);
    assert_int_equal(growth_fit(sizes, counts, 4, GROWTH_N_CUBED, GROWTH_FULL_LOOK, &fit, NULL),
                     -1);
    assert_int_equal(growth_fit(sizes, counts, 4, GROWTH_N, GROWTH_FULL_LOOK, &fit, NULL), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_are_those_of_the_manifest),
        cmocka_unit_test(each_class_is_found_and_bounded),
        cmocka_unit_test(coefficients_come_back),
        cmocka_unit_test(hidden_quadratics_are_found),
        cmocka_unit_test(a_first_look_passes_only_what_is_clear),
        cmocka_unit_test(a_first_look_agrees_with_the_full_one),
        cmocka_unit_test(a_first_look_does_not_pass_what_jumps),
        cmocka_unit_test(the_last_round_decides),
        cmocka_unit_test(sizes_where_the_constant_dominates_are_dropped),
        cmocka_unit_test(noise_fails_no_right_solution),
        cmocka_unit_test(tables_that_double_pass),
        cmocka_unit_test(steps_pass_wherever_they_are),
        cmocka_unit_test(bad_arguments_are_errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
