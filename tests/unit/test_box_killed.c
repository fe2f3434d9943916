/* An engine that is killed takes its boxes with it; the next one removes their control groups. */
#include "tests/unit/box_bench.h"

#include <poll.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/pidfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

static void engine_that_waits(int out, uint32_t disabled)
{
    struct box_plan plan = box_bench_plan("attacks", "sleep");
    struct box box;
    struct error err = {""};
    plan.disabled_layers = disabled;
    if (box_start(&plan, &box, &err) ||
        write(out, &box.program, sizeof box.program) != (ssize_t)sizeof box.program)
        _exit(1);
    for (;;)
        pause();
}

static const char sweep_option[] = "--sweep-after";
static pid_t gone_engine;

/* An engine sweeps once, and what it forks knows that it did: the next one is a new program. */
static int start_next_engine(void)
{
    char text[16];
    snprintf(text, sizeof text, "%d", (int)gone_engine);
    execl("/proc/self/exe", "test_box_killed", sweep_option, text, (char *)NULL);
    return 99;
}

/* That program: how much is left of the engine that is gone. */
static int sweep_after_engine(const char *engine)
{
    struct box_bench_end end = {.name = "exit-zero", .end = BOX_ENDED_EXIT};
    if (box_bench_open() != 0)
        return 99;
    int wrong = box_bench_expect("attacks", &end, 0) + box_bench_groups_of((pid_t)atoi(engine));
    box_bench_close();
    return wrong;
}

static void test_killed_engine(void **state)
{
    (void)state;
    static const uint32_t settings[] = {0, OFF_NAMESPACES};
    for (int i = 0; i < 2; i++) {
        int channel[2];
        pid_t program;
        assert_int_equal(pipe(channel), 0);
        pid_t engine = fork();
        if (engine == 0)
            engine_that_waits(channel[1], settings[i]);
        assert_int_equal(read(channel[0], &program, sizeof program), (ssize_t)sizeof program);
        int pidfd = pidfd_open(program, 0);
        assert_true(pidfd >= 0);
        kill(engine, SIGKILL);
        assert_int_equal(waitpid(engine, NULL, 0), engine);
        struct pollfd gone = {pidfd, POLLIN, 0};
        assert_int_equal(poll(&gone, 1, 10000), 1);
        close(pidfd);
        close(channel[0]);
        close(channel[1]);
        gone_engine = engine;
        assert_int_equal(box_bench_as(NULL, start_next_engine), 0);
    }
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], sweep_option) == 0)
        return sweep_after_engine(argv[2]);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_killed_engine)};
    return cmocka_run_group_tests(tests, box_bench_set_up, box_bench_tear_down);
}
