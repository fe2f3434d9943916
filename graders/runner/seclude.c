/* Before the first call; see seclude.h. */
#include "graders/runner/seclude.h"

#include "graders/wire/control.h"

#include <errno.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

static void close_regions(void)
{
    close(CONTROL_FD);
    close(INPUT_FD);
    close(ANSWER_FD);
}

#ifdef RUNNER_WITHOUT_SHIM
/* UBSan asks for its options when it finds its first error; a variable would be gone by then. */
const char *__ubsan_default_options(void);
const char *__ubsan_default_options(void)
{
    return "abort_on_error=0:exitcode=" EXIT_TOOL_FOUND ":color=never:print_stacktrace=0";
}
#endif

/* The texts stand on the stack, where they could be found without a name. */
static void clear_environment(void)
{
    static char path[] = "PATH=/usr/bin:/bin", language[] = "LC_ALL=C", folder[] = "TMPDIR=.";
    static char *left[] = {path, language, folder, NULL};
    for (char **variable = environ; variable && *variable; variable++)
        explicit_bzero(*variable, strlen(*variable));
    environ = left;
}

/* ------------------------------------------------------------------ filter */

enum { CODE_MOST = 64 };

struct filter {
    struct sock_filter code[CODE_MOST];
    unsigned short count;
};

static void add(struct filter *filter, struct sock_filter instruction)
{
    filter->code[filter->count++] = instruction;
}

static struct sock_filter load(size_t offset)
{
    return (struct sock_filter)BPF_STMT(BPF_LD | BPF_W | BPF_ABS, (uint32_t)offset);
}

/* Goes on with the next instruction when they are equal, else leaves out `skipped` of them. */
static struct sock_filter unless_equal(long value, unsigned char skipped)
{
    return (struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)value, 0, skipped);
}

static struct sock_filter end(uint32_t action)
{
    return (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, action);
}

static size_t argument(int index)
{
    return offsetof(struct seccomp_data, args) + sizeof(uint64_t) * (size_t)index;
}

/* Calls that kill. By a filter of its own the program could make a signal of the tool's end, and
 * jump out of it; so it could of the tool's message, past a limit of its own. */
static void refuse_calls(struct filter *filter)
{
    static const int calls[] = {SYS_execve, SYS_execveat, SYS_chdir,
                                SYS_fchdir, SYS_seccomp,  SYS_setrlimit};
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        add(filter, unless_equal(calls[i], 1));
        add(filter, end(SECCOMP_RET_KILL_PROCESS));
    }
    add(filter, unless_equal(SYS_prctl, 4));
    add(filter, load(argument(0)));
    add(filter, unless_equal(PR_SET_VMA, 1)); /* newer libcs name their memory */
    add(filter, end(SECCOMP_RET_ERRNO | EINVAL));
    add(filter, end(SECCOMP_RET_KILL_PROCESS));
    add(filter, unless_equal(SYS_prlimit64, 6)); /* reading limits is allowed */
    add(filter, load(argument(2)));
    add(filter, unless_equal(0, 3));
    add(filter, load(argument(2) + sizeof(uint32_t)));
    add(filter, unless_equal(0, 1));
    add(filter, end(SECCOMP_RET_ALLOW));
    add(filter, end(SECCOMP_RET_KILL_PROCESS));
}

/* A handler of a signal that comes from outside of the program's own instructions, as that of a file
 * that got too large or of a pipe that nobody reads, could jump out of the sanitizer's last message.
 * Setting one seems to succeed. The sanitizer itself makes pipes.
 * Faults of instructions the sanitizer keeps to itself. */
static void keep_handlers(struct filter *filter)
{
    static const int own[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT};
    enum { OWN_COUNT = sizeof own / sizeof *own };
    add(filter, unless_equal(SYS_rt_sigaction, 2 + 2 * OWN_COUNT));
    add(filter, load(argument(0)));
    for (int i = 0; i < OWN_COUNT; i++) {
        add(filter, unless_equal(own[i], 1));
        add(filter, end(SECCOMP_RET_ALLOW));
    }
    add(filter, end(SECCOMP_RET_ERRNO | 0));
}

/* A second filter over the box's own, which must let the tool itself be started and prepare itself,
 * and the box enter its folder. Calls of other architectures die by the first. */
static int give_up_calls(bool in_sanitizer)
{
    struct filter filter = {.count = 0};
    add(&filter, load(offsetof(struct seccomp_data, nr)));
    refuse_calls(&filter);
    if (in_sanitizer)
        keep_handlers(&filter);
    add(&filter, end(SECCOMP_RET_ALLOW));
    struct sock_fprog program = {filter.count, filter.code};
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0);
}

int seclude(enum secluded_in where)
{
    close_regions();
    clear_environment();
    return where == IN_NO_TOOL ? 0 : give_up_calls(where == IN_SANITIZER);
}
