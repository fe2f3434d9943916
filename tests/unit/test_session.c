/* How a session ends when the machine is slow to tell: the box's own process is stopped for a while
 * and so tells late that the program ended. */
#include "tests/unit/known_program.h"

#include <sched.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

enum { STOPPED_SECONDS = 6 /* more than a program that sits idle gets for its end */ };

static const char PROGRAM[] =
    "#include \"edge-table-any.h\"\n"
    "int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,"
    " int32_t **edges)\n{\n(void)triangles; (void)vertex_count;\n*edges = 0;\n"
    "return triangle_count;\n}\n";

/* Stops a process now, and lets it go on later. */
static pid_t stop_for_a_while(pid_t pid)
{
    assert_int_equal(kill(pid, SIGSTOP), 0);
    pid_t child = fork();
    if (child == 0) {
        sleep(STOPPED_SECONDS);
        kill(pid, SIGCONT);
        _exit(0);
    }
    return child;
}

static void test_late_news_of_an_end(void **state)
{
    static const struct call_limits limits = {20000000000LL, 20000000000LL};
    struct known_program program;
    struct error err = {""};
    struct session session;
    struct box_outcome outcome;
    (void)state;
    known_program_build(&program, PROGRAM, "");
    struct session_plan plan = known_program_plan(&program);
    plan.ends_by_itself = true;
    assert_int_equal(session_start(&session, &plan, &err), 0);
    assert_int_equal(session_call(&session, KNOWN_INPUT_BYTES, 0, &limits), CALL_ANSWERED);
    pid_t waker = stop_for_a_while(session.box.init);
    assert_int_equal(session_end(&session, &outcome, &err), 0);
    assert_int_equal(outcome.end, BOX_ENDED_EXIT);
    assert_int_equal(outcome.exit_code, 0);
    assert_int_equal(waitpid(waker, NULL, 0), waker);
    session_release(&session);
    known_program_release(&program);
}

/* ----------------------------------------------------------- how much it takes */

#define FUNCTION(body)                                                                             \
    "#include \"edge-table-any.h\"\n#include <stdlib.h>\n#include <time.h>\n"                      \
    "static void loop(void) { for (volatile int i = 0;; i++) { } }\n"                              \
    "int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t "            \
    "vertex_count, int32_t **edges)\n{\n(void)triangles; (void)vertex_count; (void)loop;\n" body   \
    "*edges = 0;\nreturn triangle_count;\n}\n"

/* Starts a program, calls it once and ends it. */
static enum call_end call_once(const char *source, const struct call_limits *limits,
                               struct budget *budget, struct box_outcome *outcome)
{
    struct known_program program;
    struct error err = {""};
    struct session session;
    known_program_build(&program, source, "");
    struct session_plan plan = known_program_plan(&program);
    plan.budget = budget;
    assert_int_equal(session_start(&session, &plan, &err), 0);
    enum call_end end = session_call(&session, KNOWN_INPUT_BYTES, 0, limits);
    assert_int_equal(session_end(&session, outcome, &err), 0);
    session_release(&session);
    known_program_release(&program);
    return end;
}

/* What a program does when it is told to end concerns nobody, unless that is asked for. */
static void test_an_end_that_tells_nothing(void **state)
{
    static const struct call_limits limits = {20000000000LL, 20000000000LL};
    struct box_outcome outcome;
    (void)state;
    assert_int_equal(call_once(FUNCTION("atexit(loop);\n"), &limits, NULL, &outcome),
                     CALL_ANSWERED);
    assert_int_equal(outcome.end, BOX_ENDED_KILLED);
    assert_true(outcome.cpu_ns < 1000000000);
}

/* Long before the limits of the call; and a budget that is spent allows no call at all. */
static void test_a_budget_ends_work(void **state)
{
    static const struct call_limits limits = {20000000000LL, 20000000000LL};
    struct budget budget = {.limit_ns = 400000000};
    struct box_outcome outcome;
    (void)state;
    assert_int_equal(call_once(FUNCTION("loop();\n"), &limits, &budget, &outcome), CALL_SPENT);
    assert_true(outcome.cpu_ns < 2000000000);
    assert_true(budget.cpu_ns >= 300000000);
    assert_true(budget_is_spent(&budget, 0));
    assert_int_equal(call_once(FUNCTION(""), &limits, &budget, &outcome), CALL_SPENT);
}

static void test_a_budget_ends_waiting(void **state)
{
    static const struct call_limits limits = {20000000000LL, 20000000000LL};
    struct budget budget = {.limit_ns = 400000000};
    struct box_outcome outcome;
    (void)state;
    assert_int_equal(call_once(FUNCTION("nanosleep(&(struct timespec){30, 0}, 0);\n"), &limits,
                               &budget, &outcome),
                     CALL_SPENT);
    assert_true(budget.idle_ns >= 300000000);
    assert_true(outcome.cpu_ns < 300000000);
}

/* What the machine takes from a program is not charged to it: it is pinned beside others that work
 * on the same CPU. */
static void test_no_budget_for_what_the_machine_takes(void **state)
{
    static const struct call_limits limits = {20000000000LL, 100000000};
    static const char work[] =
        FUNCTION("clock_t end = clock() + CLOCKS_PER_SEC / 5;\nwhile (clock() < end) { }\n");
    struct budget budget = {.limit_ns = 5000000000LL};
    struct known_program program;
    struct error err = {""};
    struct session session;
    struct box_outcome outcome;
    pid_t others[4];
    (void)state;
    known_program_build(&program, work, "");
    struct session_plan plan = known_program_plan(&program);
    plan.budget = &budget;
    plan.cpu = 0;
    for (int i = 0; i < 4; i++) {
        others[i] = fork();
        if (others[i] == 0) {
            cpu_set_t first;
            CPU_ZERO(&first);
            CPU_SET(0, &first);
            sched_setaffinity(0, sizeof first, &first);
            for (;;) {
            }
        }
    }
    assert_int_equal(session_start(&session, &plan, &err), 0);
    enum call_end end = session_call(&session, KNOWN_INPUT_BYTES, 0, &limits);
    assert_int_equal(session_end(&session, &outcome, &err), 0);
    for (int i = 0; i < 4; i++) {
        kill(others[i], SIGKILL);
        waitpid(others[i], NULL, 0);
    }
    assert_int_equal(end, CALL_ANSWERED);
    assert_true(budget.idle_ns < 100000000);
    assert_true(budget.cpu_ns >= 190000000);
    session_release(&session);
    known_program_release(&program);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_late_news_of_an_end),
                                       cmocka_unit_test(test_an_end_that_tells_nothing),
                                       cmocka_unit_test(test_a_budget_ends_work),
                                       cmocka_unit_test(test_a_budget_ends_waiting),
                                       cmocka_unit_test(test_no_budget_for_what_the_machine_takes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
