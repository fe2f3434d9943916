/* What starting a program in a box costs over fork and exec, and what each layer has of it. All
 * variants take turns, so that what else the machine does falls on each alike. */
#include "tests/unit/box_bench.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* Variants 0 to BOX_LAYER_COUNT - 1 leave that layer out. */
enum { ROUNDS = 200, EVERYTHING = BOX_LAYER_COUNT, FORK_AND_EXEC };

static int64_t now_ns(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * INT64_C(1000000000) + time.tv_nsec;
}

static int fork_and_exec(int program)
{
    static char name[] = "controls", argument[] = "nothing";
    static char *const argv[] = {name, argument, NULL}, *const envp[] = {NULL};
    int status;
    pid_t child = fork();
    if (child == 0) {
        fexecve(program, argv, envp);
        _exit(127);
    }
    return child > 0 && waitpid(child, &status, 0) == child && status == 0 ? 0 : -1;
}

static int in_box(uint32_t disabled)
{
    struct box_plan plan = box_bench_plan("controls", "nothing");
    struct box_outcome outcome;
    struct error err;
    plan.disabled_layers = disabled;
    if (box_run(&plan, &outcome, &err)) {
        fprintf(stderr, "%s\n", err.text);
        return -1;
    }
    return outcome.end == BOX_ENDED_EXIT && outcome.exit_code == 0 ? 0 : -1;
}

static int run_variant(int variant, int program)
{
    if (variant == FORK_AND_EXEC)
        return fork_and_exec(program);
    if (variant == EVERYTHING || variant == BOX_NO_NEW_PRIVILEGES) /* seccomp stands on it */
        return in_box(0);
    return in_box(1u << variant);
}

static int compare(const void *a, const void *b)
{
    const int64_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

static double fastest_us(int64_t times[ROUNDS])
{
    qsort(times, ROUNDS, sizeof *times, compare);
    return (double)times[0] / 1000;
}

int main(void)
{
    static int64_t times[FORK_AND_EXEC + 1][ROUNDS];
    double us[FORK_AND_EXEC + 1];
    if (box_bench_open())
        return 1;
    int program = box_bench_program("controls"), failed = 0;
    for (int round = 0; round < ROUNDS && !failed; round++) {
        for (int variant = 0; variant <= FORK_AND_EXEC && !failed; variant++) {
            int64_t start = now_ns();
            failed = run_variant(variant, program);
            times[variant][round] = now_ns() - start;
        }
    }
    for (int variant = 0; variant <= FORK_AND_EXEC && !failed; variant++)
        us[variant] = fastest_us(times[variant]);
    if (!failed) {
        printf("start, run and end of an empty program; the fastest of %d runs each\n", ROUNDS);
        printf("%-24s %8.0f us\n", "fork and exec", us[FORK_AND_EXEC]);
        printf("%-24s %8.0f us, %.0f over fork and exec\n", "box, every layer", us[EVERYTHING],
               us[EVERYTHING] - us[FORK_AND_EXEC]);
        for (int layer = 0; layer < BOX_LAYER_COUNT; layer++)
            printf("  of it %-22s %6.0f us\n", box_layer_name((enum box_layer)layer),
                   us[EVERYTHING] - us[layer]);
    }
    box_bench_close();
    return failed ? 1 : 0;
}
