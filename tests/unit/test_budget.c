/* A submission whose runs together take too long: a verdict that says so, whatever step it shows in,
 * and never a fault. */
#include "graders/engine/base/files.h"
#include "graders/engine/run/trial.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define ANSWER(before)                                                                             \
    "#include \"edge-table-closed.h\"\n#include \"honest.h\"\n#include <time.h>\n"                 \
    "int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count,\n"                \
    "                          int32_t vertex_count, int32_t **edges)\n{\n"                        \
    "    (void)vertex_count;\n" before                                                             \
    "    return honest_edges(triangles, triangle_count, edges);\n}\n"

static struct exercise *exercises;
static struct yardstick yardstick;
static struct trial trial;
static char *honest;
static size_t honest_bytes;

static int set_up(void **state)
{
    char path[PATH_MAX];
    struct error err = {""};
    int count;
    (void)state;
    const char *root = project_root(&err);
    if (!root || exercises_read(root, &exercises, &count, &err) != 0 ||
        file_path(path, &err, "%s/tests/hostile/honest.h", root) != 0 ||
        file_read(path, 1 << 20, &honest, &honest_bytes, &err) != 0)
        return -1;
    return yardstick_make(&yardstick, exercise_find(exercises, count, "edge-table-closed"),
                          seeds_of_class(SEED_PUBLISHED), true, &err);
}

static int tear_down(void **state)
{
    (void)state;
    yardstick_release(&yardstick);
    free(exercises);
    free(honest);
    return 0;
}

static void run(const char *text, struct trial_scope scope)
{
    struct error err = {""};
    const struct source sources[] = {{"answer.c", text, strlen(text)},
                                     {"honest.h", honest, honest_bytes}};
    int result = trial_run(&trial, &yardstick, "ana", sources, 2, &scope, &err);
    if (result != 0)
        print_error("%s\n", err.text);
    assert_int_equal(result, 0);
    assert_false(trial.build.refusal.refused);
}

/* Each case alone is within its limits. */
static void test_cases(void **state)
{
    static const char slow[] = ANSWER("    clock_t end = clock() + CLOCKS_PER_SEC / 5;\n"
                                      "    while (clock() < end) { }\n");
    size_t passed = 0, spent = 0;
    (void)state;
    run(slow, (struct trial_scope){.budget_ns = 900000000});
    for (size_t i = 0; i < yardstick.inputs.judge->case_count; i++) {
        const struct attempt *attempt = &trial.cases[i].attempt;
        passed += attempt->verdict == VERDICT_PASSED;
        if (attempt->verdict != VERDICT_CPU_TIME)
            continue;
        spent++;
        assert_string_equal(attempt->cause, "time-budget");
        assert_non_null(strstr(attempt->message.en, "300 s"));
        assert_non_null(strstr(attempt->message.es, "300 s"));
    }
    assert_true(passed >= 1);
    assert_int_equal(spent, 2); /* the rest is not run, as after any two limits of time */
    assert_int_equal(trial.checks[CHECK_UNDEFINED_BEHAVIOUR].verdict, VERDICT_NOT_REACHED);
    trial_release(&trial);
}

static void test_under_a_tool(void **state)
{
    static const char slow[] = ANSWER("    while (under_sanitizer()) { }\n");
    (void)state;
    run(slow, (struct trial_scope){.budget_ns = 3000000000});
    assert_int_equal(trial.cases[0].attempt.verdict, VERDICT_PASSED);
    assert_int_equal(trial.checks[CHECK_UNDEFINED_BEHAVIOUR].verdict, VERDICT_CPU_TIME);
    assert_string_equal(trial.checks[CHECK_UNDEFINED_BEHAVIOUR].cause, "time-budget");
    assert_int_equal(trial.checks[CHECK_ALLOCATION_FAILURE].verdict, VERDICT_NOT_REACHED);
    trial_release(&trial);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_cases),
                                       cmocka_unit_test(test_under_a_tool)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
