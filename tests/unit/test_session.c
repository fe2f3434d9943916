/* How a session ends when the machine is slow to tell: the box's own process is stopped for a while
 * and so tells late that the program ended. */
#include "tests/unit/known_program.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_late_news_of_an_end)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
