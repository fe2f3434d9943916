/* The box under attack: every hostile program has exactly the end that it must have, honest ones
 * run, and nothing is left behind; as root, as a plain user, and on machines that grant less. */
#include "tests/unit/box_bench.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/pidfd.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

#define FORBIDDEN(attack, call_name, text)                                                         \
    {                                                                                              \
        .name = attack, .end = BOX_ENDED_FORBIDDEN, .call = call_name, .detail = text              \
    }
#define PROCESS(attack, call_name)                                                                 \
    {                                                                                              \
        .name = attack, .end = BOX_ENDED_FORBIDDEN, .call = call_name, .is_process = true          \
    }

/* What each attack must end in wherever seccomp is active. */
static const struct box_bench_end attacks[] = {
    {.name = "loop", .end = BOX_ENDED_CPU, .slow = true},
    {.name = "ignore-cpu-limit", .end = BOX_ENDED_CPU, .slow = true},
    {.name = "sleep", .end = BOX_ENDED_KILLED},
    {.name = "malloc-bomb", .end = BOX_ENDED_MEMORY, .needs_group = true},
    {.name = "map-bomb", .end = BOX_ENDED_MEMORY, .needs_group = true},
    PROCESS("fork-bomb", "clone"),
    PROCESS("vfork", "vfork"),
    PROCESS("leave-children", "clone"),
    {.name = "write-everywhere", .end = BOX_ENDED_EXIT, .code = HARMLESS},
    FORBIDDEN("read-passwd", "openat", "openat /etc/passwd"),
    FORBIDDEN("read-at-page-end", "openat", "openat /etc/shadow?"),
    FORBIDDEN("read-wild-path", "openat", "openat "),
    FORBIDDEN("locale-escape", "openat", "openat /usr/lib/locale/../../../etc/passwd"),
    FORBIDDEN("write-outside", "openat", "openat /etc/box-test-escaped"),
    FORBIDDEN("kill-parent", "kill", NULL),
    FORBIDDEN("kill-all", "kill", "kill -1, signal 9"),
    FORBIDDEN("kill-thread-of-parent", "tgkill", NULL),
    FORBIDDEN("raise-kill", "tgkill", NULL),
    FORBIDDEN("trace", "ptrace", "ptrace"),
    FORBIDDEN("read-parent-memory", "process_vm_readv", NULL),
    FORBIDDEN("socket", "socket", "socket"),
    FORBIDDEN("set-dumpable", "prctl", NULL),
    FORBIDDEN("raise-limits", "prlimit64", NULL),
    FORBIDDEN("unpin", "sched_setaffinity", NULL),
    FORBIDDEN("shell", "execve", "execve /bin/sh"),
    FORBIDDEN("io-uring", "io_uring_setup", NULL),
    {.name = "int-0x80", .end = BOX_ENDED_FORBIDDEN},
    {.name = "stack-overflow", .end = BOX_ENDED_SIGNAL, .code = SIGSEGV},
    {.name = "crash", .end = BOX_ENDED_SIGNAL, .code = SIGSEGV},
    {.name = "abort", .end = BOX_ENDED_SIGNAL, .code = SIGABRT},
    {.name = "use-slots", .end = BOX_ENDED_EXIT, .code = HARMLESS},
    {.name = "exit-zero", .end = BOX_ENDED_EXIT},
    {.name = NULL},
};

/* What rlimits end. */
static const struct box_bench_end floods[] = {
    {.name = "flood", .end = BOX_ENDED_OUTPUT},
    {.name = "flood-ignoring", .end = BOX_ENDED_EXIT, .code = HARMLESS},
    {.name = NULL},
};

/* Where a container's own filter may answer first. */
static const struct box_bench_end attacks_on_namespaces[] = {
    PROCESS("thread", "clone3"),
    FORBIDDEN("unshare", "unshare", NULL),
    {.name = NULL},
};
static const struct box_bench_end attacks_in_container[] = {
    PROCESS("thread", "clone"),
    {.name = "unshare", .end = BOX_ENDED_EXIT, .code = HARMLESS},
    {.name = NULL},
};

static const struct box_bench_end controls[] = {
    {.name = "nothing", .end = BOX_ENDED_EXIT},
    {.name = "allocate", .end = BOX_ENDED_EXIT},
    {.name = "sort", .end = BOX_ENDED_EXIT},
    {.name = "print", .end = BOX_ENDED_EXIT},
    {.name = "times", .end = BOX_ENDED_EXIT},
    {.name = "signals", .end = BOX_ENDED_EXIT},
    {.name = "stdio-files", .end = BOX_ENDED_EXIT},
    {.name = "assert", .end = BOX_ENDED_SIGNAL, .code = SIGABRT},
    {.name = "corrupt-heap", .end = BOX_ENDED_SIGNAL, .code = SIGABRT},
    {.name = "smash-stack", .end = BOX_ENDED_SIGNAL, .code = SIGABRT},
    {.name = NULL},
};

/* These look for files of libc, and so need refused calls to be told to the engine. */
static const struct box_bench_end locales = {.name = "locales", .end = BOX_ENDED_EXIT};

static int everything(void)
{
    return box_bench_expect_all("attacks", attacks, 0, false) +
           box_bench_expect_all("attacks", floods, 0, false) +
           box_bench_expect_all("controls", controls, 0, false);
}

static int everything_named(void)
{
    return everything() + box_bench_expect_all("attacks", attacks_on_namespaces, 0, false) +
           box_bench_expect("controls", &locales, 0);
}

static int everything_in_container(void)
{
    return everything() + box_bench_expect_all("attacks", attacks_in_container, 0, false) +
           box_bench_expect("controls", &locales, 0);
}

/* ----------------------------------------------------------- one by one, run */

static void test_attacks_end_as_named(void **state)
{
    (void)state;
    assert_int_equal(box_bench_expect_all("attacks", attacks, 0, true), 0);
    assert_int_equal(box_bench_expect_all("attacks", floods, 0, false), 0);
    assert_int_equal(box_bench_expect_all("attacks", attacks_on_namespaces, 0, false), 0);
}

static void test_honest_programs_run(void **state)
{
    (void)state;
    assert_int_equal(box_bench_expect_all("controls", controls, 0, true), 0);
    assert_int_equal(box_bench_expect("controls", &locales, 0), 0);
}

static void test_plain_user(void **state)
{
    (void)state;
    box_bench_play(box_bench_become_nobody, everything_named);
}

static void test_plain_user_without_namespaces(void **state)
{
    (void)state;
    box_bench_play(box_bench_lose_namespaces, everything_named);
}

static void test_root_of_a_container_of_one_user(void **state)
{
    (void)state;
    box_bench_play(box_bench_lose_namespaces_as_root, everything_named);
}

static void test_container(void **state)
{
    (void)state;
    box_bench_play(box_bench_enter_container, everything_in_container);
}

static void test_without_listener_calls_kill_by_themselves(void **state)
{
    (void)state;
    box_bench_play(box_bench_lose_listener, everything);
}

/* Any layer may be missing while seccomp is there: the ends stay the same. */
static void test_each_layer_switched_off(void **state)
{
    (void)state;
    for (int layer = 0; layer < BOX_LAYER_COUNT; layer++)
        if (layer != BOX_SECCOMP && layer != BOX_NO_NEW_PRIVILEGES)
            assert_int_equal(box_bench_expect_all("attacks", attacks, 1u << layer, false), 0);
}

static void test_seccomp_and_rlimits_alone(void **state)
{
    (void)state;
    uint32_t disabled = OFF_NAMESPACES | OFF_GROUPS | OFF(PRIVATE_ROOT) | OFF(LANDLOCK);
    assert_int_equal(box_bench_expect_all("attacks", attacks, disabled, false), 0);
    assert_int_equal(box_bench_expect_all("controls", controls, disabled, false), 0);
}

/* The other walls, seen alone: the call is made, and does nothing. */
static void test_walls_behind_seccomp(void **state)
{
    static const struct box_bench_end contained[] = {
        {.name = "fork-bomb", .end = BOX_ENDED_EXIT, .code = HARMLESS},
        {.name = "thread", .end = BOX_ENDED_EXIT, .code = HARMLESS},
        {.name = "read-passwd", .end = BOX_ENDED_EXIT, .code = HARMLESS},
        {.name = "write-outside", .end = BOX_ENDED_EXIT, .code = HARMLESS},
        {.name = "raise-limits", .end = BOX_ENDED_EXIT, .code = HARMLESS},
        {.name = "shell", .end = BOX_ENDED_EXIT, .code = HARMLESS},
        {.name = "trace", .end = BOX_ENDED_EXIT, .code = HARMLESS},
        {.name = "read-parent-memory", .end = BOX_ENDED_EXIT, .code = HARMLESS},
        {.name = "crash", .end = BOX_ENDED_SIGNAL, .code = SIGSEGV},
        {.name = NULL}};
    static const struct box_bench_end no_files[] = {
        {.name = "read-passwd", .end = BOX_ENDED_EXIT, .code = HARMLESS},
        {.name = "write-outside", .end = BOX_ENDED_EXIT, .code = HARMLESS},
        {.name = NULL}};
    (void)state;
    uint32_t off = OFF(SECCOMP) | OFF(SECCOMP_NAMES);
    assert_int_equal(box_bench_expect_all("attacks", contained, off, false), 0);
    assert_int_equal(box_bench_expect_all("attacks", no_files, off | OFF(LANDLOCK), false), 0);
    assert_int_equal(box_bench_expect_all("attacks", no_files, off | OFF(PRIVATE_ROOT), false), 0);
}

/* Only CPU time is had from version 2 on a machine whose other controllers are of version 1. */
static int runs_with_version_2(void)
{
    struct box_plan plan = box_bench_plan("attacks", "sleep");
    struct box_outcome outcome;
    struct error err = {""};
    plan.wall_ms = 50;
    if (box_run(&plan, &outcome, &err) || outcome.end != BOX_ENDED_KILLED || !outcome.cleaned)
        return 1;
    if (!(outcome.active >> BOX_CGROUP_CPU & 1) || outcome.cpu_ns <= 0)
        return 2;
    plan.disabled_layers = OFF_NAMESPACES; /* then the group's own kill is used */
    if (box_run(&plan, &outcome, &err) || outcome.end != BOX_ENDED_KILLED || !outcome.cleaned)
        return 3;
    return box_bench_leftovers();
}

static void test_cgroups_of_version_2(void **state)
{
    (void)state;
    box_bench_play(box_bench_see_version_2, runs_with_version_2);
}

static int refuses_to_start(void)
{
    struct box_plan plan = box_bench_plan("attacks", "exit-zero");
    struct box_outcome outcome;
    struct error err = {""};
    if (box_run(&plan, &outcome, &err) == 0 || !strstr(err.text, "seccomp"))
        return 1;
    plan.disabled_layers = OFF(SECCOMP) | OFF(SECCOMP_NAMES);
    err.text[0] = '\0';
    if (box_run(&plan, &outcome, &err) || outcome.end != BOX_ENDED_EXIT)
        return 2;
    return box_bench_leftovers();
}

static void test_without_seccomp_nothing_runs(void **state)
{
    (void)state;
    box_bench_play(box_bench_lose_seccomp, refuses_to_start);
}

static void test_exit_in_a_constructor(void **state)
{
    (void)state;
    char early[] = "early-exit";
    char *argv[] = {early, NULL};
    struct box_plan plan = box_bench_plan("attacks", "loop");
    struct box_outcome outcome;
    struct error err = {""};
    plan.argv = argv;
    assert_int_equal(box_run(&plan, &outcome, &err), 0);
    assert_int_equal(outcome.end, BOX_ENDED_EXIT);
    assert_int_equal(outcome.exit_code, 0);
}

static void test_plans_that_cannot_be(void **state)
{
    (void)state;
    struct box_plan good = box_bench_plan("attacks", "exit-zero"), plan;
    struct box box;
    struct error err;
    int closed = fcntl(good.program_fd, F_DUPFD_CLOEXEC, 100);
    close(closed);
    for (int i = 0; i < 7; i++) {
        plan = good;
        err.text[0] = '\0';
        if (i == 0)
            plan.program_fd = -1;
        if (i == 1)
            plan.writable = "/tmp";
        if (i == 2)
            plan.readable[0] = "/etc";
        if (i == 3)
            plan.passed_count = BOX_PASSED_LIMIT + 1;
        if (i == 4)
            plan.memory_bytes = 0;
        if (i == 5)
            plan.program_fd = closed;
        if (i == 6) { /* not a program */
            plan.program_fd = open("Makefile", O_RDONLY | O_CLOEXEC);
            assert_true(plan.program_fd >= 0);
        }
        assert_int_equal(box_start(&plan, &box, &err), -1);
        assert_int_not_equal(err.text[0], '\0');
        assert_int_equal(box_bench_leftovers(), 0);
        if (i == 6)
            close(plan.program_fd);
    }
}

/* ------------------------------------------------------ descriptors, measures */

static int memory_file(const char *text)
{
    int fd = memfd_create("test", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    assert_true(fd >= 0);
    assert_int_equal(pwrite(fd, text, strlen(text), 0), (ssize_t)strlen(text));
    return fd;
}

static void test_passed_descriptors(void **state)
{
    (void)state;
    struct box_plan plan = box_bench_plan("controls", "descriptors");
    struct box_outcome outcome;
    struct error err = {""};
    char text[16] = "";
    int files[3] = {memory_file(""), memory_file("input"), memory_file("")};
    assert_int_equal(fcntl(files[1], F_ADD_SEALS, F_SEAL_WRITE | F_SEAL_GROW | F_SEAL_SHRINK), 0);
    memcpy(plan.passed, files, sizeof files);
    plan.passed_count = 3;
    assert_int_equal(box_run(&plan, &outcome, &err), 0);
    assert_int_equal(outcome.end, BOX_ENDED_EXIT);
    assert_int_equal(outcome.exit_code, 0);
    assert_int_equal(pread(files[2], text, 6, 0), 6);
    assert_string_equal(text, "answer");
    for (int i = 0; i < 3; i++)
        close(files[i]);
}

static void test_measures_from_outside(void **state)
{
    (void)state;
    struct box_plan plan = box_bench_plan("controls", "hold");
    struct box box;
    struct box_outcome outcome;
    struct error err = {""};
    char text[8] = "";
    plan.passed[0] = memory_file("");
    plan.passed_count = 1;
    assert_int_equal(box_start(&plan, &box, &err), 0);
    for (int i = 0; i < 2000 && pread(plan.passed[0], text, 4, 0) != 4; i++)
        assert_false(box_step(&box, 5));
    assert_string_equal(text, "held");
    assert_true(box_cpu_ns(&box) > 0);
    int64_t peak = box_peak_resident_bytes(&box);
    assert_true(peak > (15 << 20) && peak < (24 << 20));
    assert_int_equal(box_reset_peak(&box), 0);
    peak = box_peak_resident_bytes(&box);
    assert_true(peak > (15 << 20) && peak < (24 << 20));
    box_kill(&box);
    assert_true(box_step(&box, 5000));
    box_finish(&box, &outcome);
    assert_int_equal(outcome.end, BOX_ENDED_KILLED);
    assert_true(outcome.cleaned);
    assert_true(outcome.cpu_ns > 0);
    assert_int_equal(box_cpu_ns(&box), -1);
    assert_int_equal(box_peak_resident_bytes(&box), -1);
    close(plan.passed[0]);
}

/* Boxes at once, ended in another order; one is never stepped. */
static void test_several_boxes(void **state)
{
    (void)state;
    struct box boxes[4];
    struct box_outcome outcome;
    struct error err = {""};
    for (int i = 0; i < 4; i++) {
        struct box_plan plan = box_bench_plan("attacks", i == 3 ? "read-passwd" : "sleep");
        assert_int_equal(box_start(&plan, &boxes[i], &err), 0);
    }
    struct pollfd told = {boxes[3].notify, POLLIN, 0};
    assert_int_equal(poll(&told, 1, 10000), 1);
    box_finish(&boxes[3], &outcome);
    assert_int_equal(outcome.end, BOX_ENDED_FORBIDDEN);
    for (int i = 0; i < 3; i++) {
        box_kill(&boxes[i]);
        box_finish(&boxes[i], &outcome);
        assert_int_equal(outcome.end, BOX_ENDED_KILLED);
        assert_true(outcome.cleaned);
    }
    assert_int_equal(box_bench_leftovers(), 0);
}

/* As an engine with several jobs does: the box's processes must not wait for locks of other
 * threads. */
static void *start_many(void *wrong)
{
    for (int i = 0; i < 25; i++) {
        char name[] = "box-test-thread", attack[] = "exit-zero";
        char *argv[] = {name, attack, NULL};
        struct box_plan plan = *(struct box_plan *)wrong;
        struct box_outcome outcome;
        struct error err = {""};
        plan.argv = argv;
        char *used = malloc(1000); /* keeps the allocator's lock busy */
        bool ran = box_run(&plan, &outcome, &err) == 0;
        free(used);
        if (!ran || outcome.end != BOX_ENDED_EXIT || !outcome.cleaned) {
            fprintf(stderr, "box: in a thread: %s\n", ran ? "another end" : err.text);
            return wrong;
        }
    }
    return NULL;
}

/* Threads that come and go hold glibc's locks: a process cloned meanwhile must not want them. */
static void *nothing(void *argument)
{
    return argument;
}

static void *come_and_go(void *enough)
{
    pthread_t thread;
    while (!atomic_load((atomic_bool *)enough))
        if (pthread_create(&thread, NULL, nothing, NULL) == 0)
            pthread_join(thread, NULL);
    return NULL;
}

static void test_threads_start_boxes(void **state)
{
    static atomic_bool enough;
    pthread_t busy;
    (void)state;
    assert_int_equal(pthread_create(&busy, NULL, come_and_go, &enough), 0);
    struct box_plan plan = box_bench_plan("attacks", "exit-zero");
    pthread_t threads[4];
    for (int i = 0; i < 4; i++)
        assert_int_equal(pthread_create(&threads[i], NULL, start_many, &plan), 0);
    for (int i = 0; i < 4; i++) {
        void *wrong = NULL;
        assert_int_equal(pthread_join(threads[i], &wrong), 0);
        assert_null(wrong);
    }
    atomic_store(&enough, true);
    assert_int_equal(pthread_join(busy, NULL), 0);
    assert_int_equal(box_bench_leftovers(), 0);
}

static void test_no_descriptor_is_lost(void **state)
{
    static const char *const names[] = {"exit-zero", "socket", "malloc-bomb", "crash"};
    (void)state;
    struct box_plan plan = box_bench_plan("attacks", "exit-zero");
    struct box_outcome outcome;
    struct error err = {""};
    int before = box_bench_descriptors();
    for (int i = 0; i < 4; i++) {
        plan = box_bench_plan("attacks", names[i]);
        assert_int_equal(box_run(&plan, &outcome, &err), 0);
    }
    plan.program_fd = open("Makefile", O_RDONLY | O_CLOEXEC);
    assert_int_equal(box_run(&plan, &outcome, &err), -1);
    close(plan.program_fd);
    plan.profile = BOX_TOOLS;
    plan.program_fd = -1;
    plan.writable = "/tmp/box-test-missing";
    assert_int_equal(box_run(&plan, &outcome, &err), -1);
    assert_int_equal(box_bench_descriptors(), before);
}

static void test_probes_agree_with_boxes(void **state)
{
    (void)state;
    static struct box_probe probes[BOX_LAYER_COUNT];
    struct box_plan plan = box_bench_plan("attacks", "exit-zero");
    struct box_outcome outcome;
    struct error err = {""};
    box_probe_layers(probes);
    assert_int_equal(box_run(&plan, &outcome, &err), 0);
    for (int layer = 0; layer < BOX_LAYER_COUNT; layer++) {
        bool active = outcome.active >> layer & 1;
        const char *name = box_layer_name((enum box_layer)layer);
        if (probes[layer].works != active)
            print_error("%s: probe '%s', box '%s'\n", name, probes[layer].reason,
                        outcome.reason[layer].en);
        assert_int_equal(probes[layer].works, active);
        assert_int_equal(probes[layer].remedy[0] != '\0', !active);
        assert_int_equal(outcome.reason[layer].en[0] != '\0', !active);
        assert_int_equal(outcome.reason[layer].es[0] != '\0', !active);
    }
    assert_int_equal(box_bench_leftovers(), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_attacks_end_as_named),
        cmocka_unit_test(test_honest_programs_run),
        cmocka_unit_test(test_plain_user),
        cmocka_unit_test(test_plain_user_without_namespaces),
        cmocka_unit_test(test_root_of_a_container_of_one_user),
        cmocka_unit_test(test_container),
        cmocka_unit_test(test_without_listener_calls_kill_by_themselves),
        cmocka_unit_test(test_each_layer_switched_off),
        cmocka_unit_test(test_seccomp_and_rlimits_alone),
        cmocka_unit_test(test_walls_behind_seccomp),
        cmocka_unit_test(test_cgroups_of_version_2),
        cmocka_unit_test(test_without_seccomp_nothing_runs),
        cmocka_unit_test(test_exit_in_a_constructor),
        cmocka_unit_test(test_plans_that_cannot_be),
        cmocka_unit_test(test_passed_descriptors),
        cmocka_unit_test(test_measures_from_outside),
        cmocka_unit_test(test_several_boxes),
        cmocka_unit_test(test_threads_start_boxes),
        cmocka_unit_test(test_no_descriptor_is_lost),
        cmocka_unit_test(test_probes_agree_with_boxes),
    };
    return cmocka_run_group_tests(tests, box_bench_set_up, box_bench_tear_down);
}
