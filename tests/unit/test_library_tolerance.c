/* Real numbers: tolerances, tables against a slow comparison, and mistakes recognised. */
#include "graders/library/tolerance.h"
#include "reference/base/random.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

static const double PI = 3.14159265358979323846;

static void what_is_near_is_allowed(void **state)
{
    (void)state;
    struct tolerance absolute = {.absolute = 0.5}, relative = {.relative = 0.25};
    assert_true(tolerance_allows(&absolute, 3.5, 3));
    assert_false(tolerance_allows(&absolute, 3.5000001, 3));
    assert_true(tolerance_allows(&relative, -5, -4));
    assert_false(tolerance_allows(&relative, -5.1, -4));
    assert_false(tolerance_allows(&relative, 1e-300, 0));
    struct tolerance none = {0};
    assert_true(tolerance_allows(&none, 0.1, 0.1));
    assert_true(tolerance_allows(&none, -0.0, 0));
    assert_false(tolerance_allows(&none, nextafter(0.1, 1), 0.1));
    struct tolerance wide = {.absolute = INFINITY};
    assert_false(tolerance_allows(&wide, NAN, 0));
    assert_false(tolerance_allows(&wide, INFINITY, 0));
}

static void steps_of_numbers(void **state)
{
    (void)state;
    assert_true(float_ulp(1) == ldexp(1, -23));
    assert_true(float_ulp(-3) == ldexp(1, -22));
    assert_true(float_ulp(0) == ldexp(1, -149));
    assert_true(float_ulp(1e300) == ldexp(1, 104));
    assert_true(double_ulp(1) == ldexp(1, -52));
    assert_true(double_ulp(0) == ldexp(1, -1074));
    assert_true(double_ulp(DBL_MAX) == ldexp(1, 971));
    struct tolerance one = {.float_ulps = 1}, two = {.double_ulps = 2};
    assert_true(tolerance_allows(&one, 1 + (double)FLT_EPSILON, 1));
    assert_false(tolerance_allows(&one, 1 + 1.01 * (double)FLT_EPSILON, 1));
    assert_true(tolerance_allows(&two, 1 - 2 * DBL_EPSILON, 1));
    assert_false(tolerance_allows(&two, 1 + 3 * DBL_EPSILON, 1));
}

static void angles_are_exact_where_they_are_small(void **state)
{
    (void)state;
    for (double angle = 1e-12; angle < 4; angle *= 3) {
        const double a[3] = {1e-200, 0, 0};
        const double b[3] = {1e200 * cos(angle), 1e200 * sin(angle), 0};
        double right = angle > PI ? 2 * PI - angle : angle;
        assert_true(fabs(angle_between(a, b) - right) <= 1e-15 * right + 1e-15);
    }
    const double zero[3] = {0, 0, 0}, x[3] = {1, 0, 0}, bad[3] = {NAN, 1, 0};
    assert_true(isnan(angle_between(zero, x)));
    assert_true(isnan(angle_between(x, bad)));
    assert_true(fabs(angle_difference(PI - 0.1, 0.1 - PI) - 0.2) < 1e-15);
    assert_true(angle_difference(0.25, 0.25 + 8 * PI) < 1e-14);
}

static void the_first_and_the_worst_row_are_told(void **state)
{
    (void)state;
    const double right[] = {1, 2, 3, 4, 5, 6, 7, 8};
    const float found[] = {1, 2, 3, 4.5F, 5, 9, NAN, 8};
    struct reals reals = {.floats = found};
    struct real_rule rule = {.tolerance = {.absolute = 0.25}};
    struct real_fault fault;
    assert_int_equal(reals_compare(&reals, right, 3, 2, &rule, &fault, NULL), 0);
    assert_int_equal(fault.row, 1);
    assert_int_equal(fault.column, 1);
    assert_true(fault.found == 4.5 && fault.right == 4);
    assert_int_equal(fault.wrong_count, 2);
    assert_int_equal(fault.worst_row, 2);
    assert_int_equal(fault.worst_column, 1);
    assert_true(fault.worst_error == 3);
    assert_int_equal(fault.not_finite_row, -1);
    real_fault_release(&fault);
    real_fault_release(&fault);
    assert_int_equal(reals_compare(&reals, right, 4, 2, &rule, &fault, NULL), 0);
    const uint8_t marks[] = {0, 1, 1, 1};
    assert_memory_equal(fault.marks, marks, 4);
    assert_int_equal(fault.worst_row, 3);
    assert_true(isinf(fault.worst_error));
    assert_int_equal(fault.not_finite_row, 3);
    assert_int_equal(fault.not_finite_count, 1);
    real_fault_release(&fault);
    const double scale[] = {1, 10, 20, 1};
    rule = (struct real_rule){.tolerance = {.relative = 0.1}, .scale = scale};
    assert_int_equal(reals_compare(&reals, right, 3, 2, &rule, &fault, NULL), 0);
    assert_int_equal(fault.row, 2); /* 9 is off by 3, and 2 are allowed */
    real_fault_release(&fault);
}

static void directions_have_no_length(void **state)
{
    (void)state;
    const double right[] = {0, 0, 1, 1, 0, 0, 0, 1, 0};
    const double found[] = {0, 0, 7, 1, 1e-7, 0, 0, 0, 0};
    struct reals reals = {.doubles = found};
    struct real_rule rule = {.kind = REAL_DIRECTIONS, .tolerance = {.absolute = 1e-6}};
    struct real_fault fault;
    assert_int_equal(reals_compare(&reals, right, 3, 3, &rule, &fault, NULL), 0);
    assert_int_equal(fault.row, 2);
    assert_int_equal(fault.wrong_count, 1);
    real_fault_release(&fault);
    assert_int_equal(reals_compare(&reals, right, 3, 2, &rule, &fault, NULL), -1);
    const double angles[] = {PI, 0}, turned[] = {-PI, 2 * PI};
    reals.doubles = turned;
    rule.kind = REAL_ANGLES;
    assert_int_equal(reals_compare(&reals, angles, 2, 1, &rule, &fault, NULL), 0);
    assert_int_equal(fault.wrong_count, 0);
    real_fault_release(&fault);
}

/* -- mistakes --------------------------------------------------------------------------------- */

enum { ROWS = 12 };

static const char *mistake_of(const double *found, const double *right, int rows)
{
    struct reals reals = {.doubles = found};
    struct real_rule rule = {.tolerance = {.relative = 1e-9, .absolute = 1e-12}};
    const struct mistake *mistake =
        reals_mistake(&reals, right, rows, 1, &rule, tolerance_usual_mistakes, NULL);
    return mistake ? mistake->cause.slug : "";
}

static void usual_mistakes_are_recognised(void **state)
{
    (void)state;
    double right[ROWS], found[ROWS];
    for (int i = 0; i < ROWS; i++)
        right[i] = i == 3 ? 0 : 0.3 + 0.37 * i - (i % 4 == 1 ? 3 : 0);
    static const struct {
        double factor;
        const char *slug;
    } factors[] = {{0, "zero-everywhere"},
                   {-1, "opposite-sign"},
                   {2, "twice"},
                   {0.5, "half"},
                   {3, "three-times"},
                   {1.0 / 3, "one-third"},
                   {6, "six-times"},
                   {180 / 3.14159265358979323846, "degrees"},
                   {1.25, ""},
                   {1 + 1e-7, "float-precision"}};
    for (size_t f = 0; f < sizeof factors / sizeof *factors; f++) {
        for (int i = 0; i < ROWS; i++)
            found[i] = factors[f].factor * right[i];
        assert_string_equal(mistake_of(found, right, ROWS), factors[f].slug);
        found[ROWS - 1] += 0.01; /* one row that does not agree: no hint */
        assert_string_equal(mistake_of(found, right, ROWS), "");
    }
    for (int i = 0; i < ROWS; i++)
        found[i] = fabs(right[i]);
    assert_string_equal(mistake_of(found, right, ROWS), "sign-lost");
    for (int i = 0; i < ROWS; i++)
        found[i] = right[i] * right[i];
    assert_string_equal(mistake_of(found, right, ROWS), "squared");
    for (int i = 0; i < ROWS; i++)
        found[i] = PI - right[i];
    assert_string_equal(mistake_of(found, right, ROWS), "other-angle");
    found[0] = NAN;
    assert_string_equal(mistake_of(found, right, ROWS), "");
    assert_string_equal(mistake_of(found, right, 0), "");
}

static double shifted(const struct mistake_place *place)
{
    const double *table = place->context;
    return table[place->row + 1] + place->column;
}

static void mistakes_of_an_exercise_have_a_context(void **state)
{
    (void)state;
    static const struct mistake list[] = {
        {.cause = {"shifted", {"shifted", "desplazado"}}, .value = shifted},
        {.cause = {NULL, {NULL, NULL}}}};
    const double table[] = {1, 2, 3}, right[] = {1, 2, 2, 3};
    const float found[] = {2, 3, 3, 4};
    struct reals reals = {.floats = found};
    struct real_rule rule = {.tolerance = {.absolute = 1e-6}};
    assert_ptr_equal(reals_mistake(&reals, right, 2, 2, &rule, list, table), list);
}

/* -- against a slow comparison ---------------------------------------------------------------- */

static void random_tables_are_told_as_slowly(void **state)
{
    (void)state;
    static const double wild[] = {NAN, INFINITY, -INFINITY, 1e300, -0.0};
    struct random rng;
    random_init(&rng, 71);
    for (int trial = 0; trial < 20000; trial++) {
        double right[3 * ROWS], found[3 * ROWS], worst = -1;
        int width = 1 + (int)random_below(&rng, 3);
        int rows = (int)random_below(&rng, ROWS + 1), wrong = 0, first = -1, worst_row = -1;
        struct real_rule rule = {.tolerance = {.absolute = 0.5, .relative = 0.25}};
        for (int r = 0; r < rows; r++) {
            bool is_wrong = false;
            for (int i = r * width; i < (r + 1) * width; i++) {
                right[i] = (double)random_below(&rng, 9) - 4;
                found[i] = random_below(&rng, 3) ? right[i] + (double)random_below(&rng, 5) / 4
                                                 : wild[random_below(&rng, 5)];
                double error = isfinite(found[i]) ? fabs(found[i] - right[i]) : (double)INFINITY;
                double excess = error / (0.5 + 0.25 * fabs(right[i]));
                if (excess > 1 && excess > worst) {
                    worst = excess;
                    worst_row = r;
                }
                is_wrong = is_wrong || excess > 1;
            }
            wrong += is_wrong;
            if (is_wrong && first < 0)
                first = r;
        }
        struct reals reals = {.doubles = found};
        struct real_fault fault;
        assert_int_equal(reals_compare(&reals, right, rows, width, &rule, &fault, NULL), 0);
        assert_int_equal(fault.wrong_count, wrong);
        assert_int_equal(fault.row, first);
        assert_int_equal(fault.worst_row, worst_row);
        real_fault_release(&fault);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_near_is_allowed),
        cmocka_unit_test(steps_of_numbers),
        cmocka_unit_test(angles_are_exact_where_they_are_small),
        cmocka_unit_test(the_first_and_the_worst_row_are_told),
        cmocka_unit_test(directions_have_no_length),
        cmocka_unit_test(usual_mistakes_are_recognised),
        cmocka_unit_test(mistakes_of_an_exercise_have_a_context),
        cmocka_unit_test(random_tables_are_told_as_slowly),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
