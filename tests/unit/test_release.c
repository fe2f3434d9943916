/* What was never made owns nothing: to release it leaves every descriptor open, 0 above all. */
#include "graders/engine/run/region.h"
#include "graders/engine/run/trial.h"

#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <unistd.h>

#include <cmocka.h>

static int open_standard_input(void **state)
{
    (void)state;
    int null = open("/dev/null", O_RDONLY);
    return null >= 0 && dup2(null, STDIN_FILENO) == STDIN_FILENO ? 0 : -1;
}

static void assert_standard_input_is_open(void)
{
    assert_true(fcntl(STDIN_FILENO, F_GETFD) >= 0);
}

static void test_build(void **state)
{
    static struct build build;
    (void)state;
    build_clear(&build);
    build_release(&build);
    build_release(&build);
    assert_standard_input_is_open();
}

static void test_region(void **state)
{
    struct region region = {0};
    (void)state;
    region_release(&region);
    region_release(&region);
    assert_standard_input_is_open();
}

/* More cases than there is memory for. */
static void test_trial_without_memory(void **state)
{
    static struct trial trial;
    static struct yardstick yardstick;
    static const struct judge judge = {.exercise = "huge", .case_count = SIZE_MAX / 2};
    static const struct exercise exercise;
    static const struct trial_scope scope;
    struct error err = {""};
    (void)state;
    yardstick.inputs.judge = &judge;
    yardstick.inputs.exercise = &exercise;
    assert_int_equal(trial_run(&trial, &yardstick, "ana", NULL, 0, &scope, &err), -1);
    assert_string_equal(err.text, "out of memory");
    trial_release(&trial);
    assert_standard_input_is_open();
}

static void test_yardstick_that_was_not_made(void **state)
{
    static struct yardstick yardstick;
    static const struct exercise exercise = {.name = "no-such-exercise"};
    struct error err = {""};
    (void)state;
    assert_int_equal(
        yardstick_make(&yardstick, &exercise, seeds_of_class(SEED_PUBLISHED), true, &err), -1);
    yardstick_release(&yardstick);
    yardstick_release(&yardstick);
    assert_standard_input_is_open();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_build, open_standard_input),
        cmocka_unit_test_setup(test_region, open_standard_input),
        cmocka_unit_test_setup(test_trial_without_memory, open_standard_input),
        cmocka_unit_test_setup(test_yardstick_that_was_not_made, open_standard_input),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
