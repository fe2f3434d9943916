/* A bench for the tests of the box: compiled hostile and honest programs, plans to run them, and
 * the hunt for what was left behind. */
#ifndef TESTS_UNIT_BOX_BENCH_H
#define TESTS_UNIT_BOX_BENCH_H

#include "graders/box/box.h"

/* Layers to leave out of a plan, as bits of its disabled_layers. */
#define OFF(name) (1u << BOX_##name)
#define OFF_NAMESPACES                                                                             \
    (OFF(USER_NAMESPACE) | OFF(PID_NAMESPACE) | OFF(MOUNT_NAMESPACE) | OFF(NET_NAMESPACE) |        \
     OFF(IPC_NAMESPACE) | OFF(UTS_NAMESPACE))
#define OFF_GROUPS (OFF(CGROUP_MEMORY) | OFF(CGROUP_PIDS) | OFF(CGROUP_CPU))

/* What an attack exits with when it did what it wanted and nothing came of it. */
enum { HARMLESS = 7 };

/* Compiles tests/hostile/box into a private folder under /tmp, with gcc -static. 0 or -1. */
int box_bench_open(void);
void box_bench_close(void);

/* The same, as set-up and tear-down of a group of tests. */
int box_bench_set_up(void **state);
int box_bench_tear_down(void **state);

/* The private folder; everyone may pass through it. */
const char *box_bench_folder(void);

/* A descriptor of "attacks" or "controls", executable by anyone. */
int box_bench_program(const char *program);

/* A plan for BOX_RUN with small limits: 64 MiB, 1 s of CPU, 1 MiB of output. Its argv[0] is a name
 * that only this process uses, argv[1] is `name`. The result points into static memory. */
struct box_plan box_bench_plan(const char *program, const char *name);

/* How something must end; fields left 0 are not looked at, but the end and the codes are. */
struct box_bench_end {
    const char *name;
    enum box_end end;
    int code;         /* exit code, or signal */
    const char *call; /* first refused call; NULL: none, or not told */
    const char *detail;
    bool is_process;
    bool needs_group; /* where address space bounds it instead of a cgroup, it exits with 7 */
    bool slow;        /* burns CPU for seconds */
};

/* Runs `program` with `disabled` layers. Prints what was wrong; returns the number of wrong things:
 * another end than expected, something left behind, a fault. */
int box_bench_expect(const char *program, const struct box_bench_end *expected, uint32_t disabled);

/* All of a list that ends with an entry without name; slow ones only when asked for. */
int box_bench_expect_all(const char *program, const struct box_bench_end *list, uint32_t disabled,
                         bool slow_ones);

/* The number of processes with our argv[0], and of cgroups with our process id; and of cgroups of
 * another process. */
int box_bench_leftovers(void);
int box_bench_groups_of(pid_t engine);

/* The number of open descriptors of this process. */
int box_bench_descriptors(void);

/* Runs `body` in a forked child that first becomes what `prepare` makes of it (NULL: nothing).
 * Returns what body returns, 0 to 99; 100 when prepare failed (then the machine cannot play that
 * part). */
int box_bench_as(int (*prepare)(void), int (*body)(void));

/* The same as a part of a test: fails unless body returns 0, skips the test where the machine
 * cannot play the part. */
void box_bench_play(int (*prepare)(void), int (*body)(void));

/* Parts to play, for box_bench_as; each 0 or -1. */
int box_bench_become_nobody(void);           /* a plain user */
int box_bench_lose_namespaces(void);         /* a plain user without user namespaces */
int box_bench_lose_namespaces_as_root(void); /* in a container of one user */
int box_bench_see_version_2(void);           /* of cgroups; where both versions are mounted */
int box_bench_enter_container(void); /* mounts, namespaces and Landlock refused, as Docker does */
int box_bench_lose_listener(void);   /* no seccomp user notification */
int box_bench_lose_seccomp(void);    /* no seccomp at all */

#endif
