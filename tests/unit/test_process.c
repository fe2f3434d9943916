/* A worker that died shows as an error of the one who asks it, and starting one changes nothing for
 * the rest of the program. */
#include "bench/measure/process.h"

#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

enum { SECONDS = 600 };

static struct process process;

static void start(const char *script)
{
    const char *const argv[] = {"/bin/sh", "-c", script, NULL};
    struct error err = {""};
    assert_int_equal(process_start(&process, argv, NULL, &err), 0);
}

static void test_the_caller_keeps_its_signals(void **state)
{
    struct sigaction action;
    (void)state;
    start("read line; echo \"$line, too\"");
    struct error err = {""};
    assert_int_equal(process_ask(&process, "warm", "area", SECONDS, &err), 0);
    assert_string_equal(process.line, "warm area, too");
    assert_int_equal(sigaction(SIGPIPE, NULL, &action), 0);
    assert_true(action.sa_handler == SIG_DFL);
    assert_true(process_stop(&process, SECONDS));
}

static void test_the_worker_ignores_no_signal(void **state)
{
    struct error err = {""};
    (void)state;
    for (int i = 0; i < 2; i++) { /* the second one is started by a program that has started one */
        start("grep SigIgn /proc/self/status");
        assert_int_equal(process_read(&process, SECONDS, &err), 0);
        assert_int_equal(strncmp(process.line, "SigIgn:", 7), 0);
        unsigned long ignored = strtoul(process.line + 7, NULL, 16);
        assert_int_equal(ignored & 1UL << (SIGPIPE - 1), 0);
        assert_true(process_stop(&process, SECONDS));
    }
}

/* It has closed its input when it says so: what is written then can only fail. */
static void test_a_worker_that_does_not_listen(void **state)
{
    struct error err = {""};
    (void)state;
    start("exec <&-; echo deaf; exit 3");
    assert_int_equal(process_read(&process, SECONDS, &err), 0);
    assert_string_equal(process.line, "deaf");
    assert_int_equal(process_ask(&process, "warm", "area", SECONDS, &err), -1);
    assert_string_equal(err.text, "the worker ended with 3");
    process_stop(&process, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_caller_keeps_its_signals),
        cmocka_unit_test(test_the_worker_ignores_no_signal),
        cmocka_unit_test(test_a_worker_that_does_not_listen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
