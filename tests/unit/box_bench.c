/* See box_bench.h. */
#include "tests/unit/box_bench.h"

#include <ctype.h>
#include <dirent.h>
#include <fcntl.h>
#include <ftw.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

enum { CANNOT_PLAY = 100 };

static char folder[64];
static char own_name[64];
static int leftover_groups;
static char group_mark[64];

static int compile(const char *program)
{
    char command[512];
    snprintf(
        command, sizeof command,
        "gcc -std=gnu17 -O1 -static -w -fstack-protector-all tests/hostile/box/%s.c -o %s/%s -lm",
        program, folder, program);
    return system(command) == 0 ? 0 : -1;
}

int box_bench_open(void)
{
    snprintf(folder, sizeof folder, "/tmp/box-test-XXXXXX");
    if (!mkdtemp(folder) || chmod(folder, 0711))
        return -1;
    snprintf(own_name, sizeof own_name, "box-test-%d", getpid());
    return compile("attacks") || compile("controls") ? -1 : 0;
}

static int remove_entry(const char *path, const struct stat *about, int type, struct FTW *walk)
{
    (void)about;
    (void)type;
    (void)walk;
    return remove(path);
}

void box_bench_close(void)
{
    nftw(folder, remove_entry, 16, FTW_DEPTH | FTW_PHYS);
}

int box_bench_set_up(void **state)
{
    (void)state;
    return box_bench_open();
}

int box_bench_tear_down(void **state)
{
    (void)state;
    box_bench_close();
    return 0;
}

const char *box_bench_folder(void)
{
    return folder;
}

int box_bench_program(const char *program)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, program);
    return open(path, O_RDONLY | O_CLOEXEC);
}

struct box_plan box_bench_plan(const char *program, const char *name)
{
    static char argument[64];
    static char *argv[3] = {own_name, argument, NULL};
    static int attacks = -1, controls = -1;
    int *fd = strcmp(program, "attacks") == 0 ? &attacks : &controls;
    if (*fd < 0)
        *fd = box_bench_program(program);
    snprintf(argument, sizeof argument, "%s", name);
    return (struct box_plan){.profile = BOX_RUN,
                             .argv = argv,
                             .program_fd = *fd,
                             .input_fd = -1,
                             .output_fd = -1,
                             .error_fd = -1,
                             .memory_bytes = 64 << 20,
                             .file_bytes = 1 << 20,
                             .scratch_bytes = 4 << 20,
                             .stack_bytes = 8 << 20,
                             .cpu_seconds = 1,
                             .wall_ms = 20000,
                             .process_count = 8,
                             .cpu = -1};
}

/* -------------------------------------------------------------- leftovers */

static int count_processes(void)
{
    DIR *processes = opendir("/proc");
    struct dirent *entry;
    int count = 0;
    while (processes && (entry = readdir(processes))) {
        char path[300], line[64] = "";
        if (!isdigit((unsigned char)entry->d_name[0]))
            continue;
        snprintf(path, sizeof path, "/proc/%s/cmdline", entry->d_name);
        int fd = open(path, O_RDONLY | O_CLOEXEC);
        if (fd >= 0 && read(fd, line, sizeof line - 1) > 0 && strcmp(line, own_name) == 0)
            count++;
        if (fd >= 0)
            close(fd);
    }
    if (processes)
        closedir(processes);
    return count;
}

static int look_at_group(const char *path, const struct stat *about, int type, struct FTW *walk)
{
    (void)about;
    if (type == FTW_D && strncmp(path + walk->base, group_mark, strlen(group_mark)) == 0)
        leftover_groups++;
    return 0;
}

int box_bench_groups_of(pid_t engine)
{
    leftover_groups = 0;
    snprintf(group_mark, sizeof group_mark, "meshgrade.%d.", engine);
    nftw("/sys/fs/cgroup", look_at_group, 16, FTW_PHYS);
    return leftover_groups;
}

int box_bench_descriptors(void)
{
    DIR *open_ones = opendir("/proc/self/fd");
    int count = 0;
    while (open_ones && readdir(open_ones))
        count++;
    if (open_ones)
        closedir(open_ones);
    return count;
}

int box_bench_leftovers(void)
{
    return box_bench_groups_of(getpid()) + count_processes();
}

/* ------------------------------------------------------------ expectations */

static int complain(const char *name, uint32_t disabled, const char *what, const char *detail)
{
    fprintf(stderr, "box: %s (disabled layers %#x): %s %s\n", name, disabled, what, detail);
    return 1;
}

static int compare(const struct box_bench_end *expected, const struct box_outcome *outcome,
                   uint32_t disabled)
{
    static const char *const ends[] = {"forbidden", "memory", "output", "disk", "cpu",
                                       "killed",    "signal", "exit",   "lost"};
    enum box_end end = expected->end;
    int code = expected->code, wrong = 0;
    bool named = outcome->active >> BOX_SECCOMP_NAMES & 1;
    bool groups = outcome->active >> BOX_CGROUP_MEMORY & 1;
    bool limits = outcome->active >> BOX_RLIMITS & 1;
    if (expected->needs_group && !groups && limits) { /* malloc gives NULL */
        end = BOX_ENDED_EXIT;
        code = HARMLESS;
    }
    if (outcome->end != end)
        wrong += complain(expected->name, disabled, "ended otherwise:", ends[outcome->end]);
    if (end == BOX_ENDED_EXIT && outcome->exit_code != code)
        wrong += complain(expected->name, disabled, "another exit code", "");
    if (end == BOX_ENDED_SIGNAL && outcome->signal != code)
        wrong += complain(expected->name, disabled, "another signal", "");
    if (named && strcmp(outcome->refused_call, expected->call ? expected->call : "") != 0)
        wrong += complain(expected->name, disabled, "another call:", outcome->refused_call);
    if (named && expected->detail && strcmp(outcome->refused_detail, expected->detail) != 0)
        wrong += complain(expected->name, disabled, "another detail:", outcome->refused_detail);
    if (named && outcome->refused_is_process != expected->is_process)
        wrong += complain(expected->name, disabled, "process or not", "");
    if (!outcome->cleaned)
        wrong += complain(expected->name, disabled, "not cleaned", "");
    return wrong;
}

int box_bench_expect(const char *program, const struct box_bench_end *expected, uint32_t disabled)
{
    struct box_plan plan = box_bench_plan(program, expected->name);
    struct box_outcome outcome;
    struct error err = {""};
    plan.disabled_layers = disabled;
    plan.output_fd = plan.error_fd = memfd_create("output", MFD_CLOEXEC);
    if (expected->end == BOX_ENDED_KILLED)
        plan.wall_ms = 100;
    int wrong = 0;
    if (box_run(&plan, &outcome, &err))
        wrong = complain(expected->name, disabled, "fault:", err.text);
    else
        wrong = compare(expected, &outcome, disabled);
    close(plan.output_fd);
    if (box_bench_leftovers())
        wrong += complain(expected->name, disabled, "left something behind", "");
    return wrong;
}

int box_bench_expect_all(const char *program, const struct box_bench_end *list, uint32_t disabled,
                         bool slow_ones)
{
    int wrong = 0;
    for (; list->name; list++)
        if (slow_ones || !list->slow)
            wrong += box_bench_expect(program, list, disabled);
    return wrong;
}

/* -------------------------------------------------------------- other parts */

int box_bench_as(int (*prepare)(void), int (*body)(void))
{
    int status;
    fflush(NULL);
    pid_t child = fork();
    if (child < 0)
        return CANNOT_PLAY;
    if (child == 0) {
        snprintf(own_name, sizeof own_name, "box-test-%d", getpid());
        if (prepare && prepare())
            _exit(CANNOT_PLAY);
        int result = body();
        _exit(result > 99 ? 99 : result);
    }
    if (waitpid(child, &status, 0) != child || !WIFEXITED(status))
        return 99;
    return WEXITSTATUS(status);
}

void box_bench_play(int (*prepare)(void), int (*body)(void))
{
    int result = box_bench_as(prepare, body);
    if (result == CANNOT_PLAY) {
        print_message("this machine cannot play that part (not root, or no user namespaces)\n");
        skip();
    }
    assert_int_equal(result, 0);
}
