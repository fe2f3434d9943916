/* The seccomp filter. The engine builds it with libseccomp before it clones; the program's process
 * fills in its own id and loads it as the last thing before exec.
 *
 * RUN: a list of allowed calls, everything else is refused. TOOLS and BUILD: allowed calls,
 * forbidden calls, and ENOSYS for the unknown. A refused call is told to the engine, which ends the
 * program; where the kernel or a container cannot do that, the call itself kills the program
 * (SIGSYS). */
#include "graders/box/inside.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <sched.h>
#include <seccomp.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

/* Stands in the built filter for the program's process id. */
enum { OWN_ID_MARK = 0x6d657368 };

static const uint64_t namespace_flags[] = {CLONE_NEWNS,  CLONE_NEWCGROUP, CLONE_NEWUTS,
                                           CLONE_NEWIPC, CLONE_NEWUSER,   CLONE_NEWPID,
                                           CLONE_NEWNET};

/* The rules under construction; the first error stays. */
struct rules {
    scmp_filter_ctx context;
    uint32_t refuse;
    int error;
};

static void add(struct rules *rules, uint32_t action, int call, unsigned count,
                const struct scmp_arg_cmp *conditions)
{
    int rc = seccomp_rule_add_array(rules->context, action, call, count, conditions);
    if (rc && !rules->error)
        rules->error = rc;
}

static void add_all(struct rules *rules, uint32_t action, const char *const *names)
{
    for (; *names; names++) {
        int call = seccomp_syscall_resolve_name(*names);
        if (call != __NR_SCMP_ERROR)
            add(rules, action, call, 0, NULL);
    }
}

static struct scmp_arg_cmp argument(unsigned index, enum scmp_compare how, uint64_t value)
{
    return (struct scmp_arg_cmp){.arg = index, .op = how, .datum_a = value};
}

static struct scmp_arg_cmp masked(unsigned index, uint64_t mask, uint64_t value)
{
    return (struct scmp_arg_cmp){
        .arg = index, .op = SCMP_CMP_MASKED_EQ, .datum_a = mask, .datum_b = value};
}

static void add_if(struct rules *rules, uint32_t action, int call, struct scmp_arg_cmp condition)
{
    add(rules, action, call, 1, &condition);
}

static void add_if2(struct rules *rules, uint32_t action, int call, struct scmp_arg_cmp first,
                    struct scmp_arg_cmp second)
{
    struct scmp_arg_cmp both[] = {first, second};
    add(rules, action, call, 2, both);
}

/* abort() sends itself SIGABRT. Nothing else is a program's own business. */
static void allow_abort(struct rules *rules)
{
    add_if2(rules, SCMP_ACT_ALLOW, SCMP_SYS(tgkill), argument(0, SCMP_CMP_EQ, OWN_ID_MARK),
            argument(2, SCMP_CMP_EQ, SIGABRT));
}

static void add_run(struct rules *rules)
{
    const uint32_t allow = SCMP_ACT_ALLOW;
    add_all(rules, allow, calls_run);
    allow_abort(rules);
    /* fstat of glibc 2.33 and later; never of a path that matters, since none is visible */
    add_if(rules, allow, SCMP_SYS(newfstatat), argument(3, SCMP_CMP_EQ, AT_EMPTY_PATH));
    add_if2(rules, allow, SCMP_SYS(prlimit64), argument(0, SCMP_CMP_EQ, 0),
            argument(2, SCMP_CMP_EQ, 0));
    add_if(rules, allow, SCMP_SYS(fcntl), argument(1, SCMP_CMP_EQ, F_GETFL));
    add_if(rules, allow, SCMP_SYS(fcntl), argument(1, SCMP_CMP_EQ, F_GETFD));
    /* static start-up looks for /proc/self/exe; stdio asks whether /dev/null is a terminal; newer
     * libcs name their memory */
    add(rules, SCMP_ACT_ERRNO(ENOENT), SCMP_SYS(readlink), 0, NULL);
    add(rules, SCMP_ACT_ERRNO(ENOENT), SCMP_SYS(readlinkat), 0, NULL);
    add_if(rules, SCMP_ACT_ERRNO(ENOTTY), SCMP_SYS(ioctl), argument(1, SCMP_CMP_EQ, TCGETS));
    add_if(rules, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(prctl), argument(0, SCMP_CMP_EQ, PR_SET_VMA));
    /* the box's own last two steps, on descriptors that exec closes */
    add_if(rules, allow, SCMP_SYS(sendmsg), argument(0, SCMP_CMP_EQ, SLOT_NOTES));
    add_if2(rules, allow, SCMP_SYS(execveat), argument(0, SCMP_CMP_EQ, SLOT_PROGRAM),
            argument(4, SCMP_CMP_EQ, AT_EMPTY_PATH));
}

/* Signals: only to itself, and in TOOLS only those that the kernel sends for what a program does:
 * valgrind ends by them itself. Any other (ENOSYS) would look as if somebody outside had ended the
 * program. A compiler may be of several processes, of which the filter knows one. */
static void add_signals(struct rules *rules, bool several)
{
    static const int calls[] = {SCMP_SYS(kill), SCMP_SYS(tkill), SCMP_SYS(tgkill)};
    static const int own[] = {SIGSEGV, SIGBUS, SIGFPE,  SIGILL,  SIGTRAP,
                              SIGABRT, SIGSYS, SIGPIPE, SIGXCPU, SIGXFSZ};
    if (several) {
        add_if(rules, SCMP_ACT_ALLOW, SCMP_SYS(tgkill), argument(2, SCMP_CMP_EQ, SIGABRT));
        add(rules, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(kill), 0, NULL);
        add(rules, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(tkill), 0, NULL);
        return;
    }
    for (size_t i = 0; i < sizeof calls / sizeof calls[0]; i++) {
        unsigned of_signal = calls[i] == SCMP_SYS(tgkill) ? 2 : 1;
        add_if(rules, rules->refuse, calls[i], argument(0, SCMP_CMP_NE, OWN_ID_MARK));
        for (size_t j = 0; j < sizeof own / sizeof own[0]; j++)
            add_if2(rules, SCMP_ACT_ALLOW, calls[i], argument(0, SCMP_CMP_EQ, OWN_ID_MARK),
                    argument(of_signal, SCMP_CMP_EQ, (uint64_t)own[j]));
    }
}

static void add_processes(struct rules *rules)
{
    uint64_t every = 0;
    add_all(rules, SCMP_ACT_ALLOW, calls_processes);
    for (size_t i = 0; i < sizeof namespace_flags / sizeof namespace_flags[0]; i++) {
        every |= namespace_flags[i];
        add_if(rules, rules->refuse, SCMP_SYS(clone),
               masked(0, namespace_flags[i], namespace_flags[i]));
    }
    add_if(rules, SCMP_ACT_ALLOW, SCMP_SYS(clone), masked(0, every, 0));
    /* clone3, whose flags a filter cannot see, is answered ENOSYS as an unknown call. */
}

static void refuse_processes(struct rules *rules)
{
    static const char *const calls[] = {"fork", "vfork", "clone", "clone3", NULL};
    add_all(rules, rules->refuse, calls);
}

static void add_tools(struct rules *rules, enum box_profile profile)
{
    static const uint64_t requests[] = {TCGETS, TIOCGWINSZ, FIONREAD, FIOCLEX};
    /* Those that make the kernel send signals are left out: a filter cannot see their target. */
    static const uint64_t commands[] = {F_DUPFD,      F_DUPFD_CLOEXEC, F_GETFD,     F_SETFD,
                                        F_GETFL,      F_SETFL,         F_GETLK,     F_SETLK,
                                        F_SETLKW,     F_OFD_GETLK,     F_OFD_SETLK, F_OFD_SETLKW,
                                        F_GETPIPE_SZ, F_SETPIPE_SZ};
    add_all(rules, SCMP_ACT_ALLOW, calls_tools);
    add_all(rules, rules->refuse, calls_forbidden);
    add_all(rules, SCMP_ACT_ERRNO(EPERM), calls_quiet);
    add_signals(rules, profile == BOX_BUILD);
    if (profile == BOX_BUILD)
        add_processes(rules);
    else
        refuse_processes(rules);
    add_if(rules, SCMP_ACT_ALLOW, SCMP_SYS(prlimit64), argument(0, SCMP_CMP_EQ, 0));
    for (size_t i = 0; i < sizeof requests / sizeof requests[0]; i++)
        add_if(rules, SCMP_ACT_ALLOW, SCMP_SYS(ioctl), argument(1, SCMP_CMP_EQ, requests[i]));
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++)
        add_if(rules, SCMP_ACT_ALLOW, SCMP_SYS(fcntl), argument(1, SCMP_CMP_EQ, commands[i]));
    add_if(rules, SCMP_ACT_ALLOW, SCMP_SYS(sendmsg), argument(0, SCMP_CMP_EQ, SLOT_NOTES));
}

/* A finished filter as the kernel takes it. */
struct built {
    struct sock_filter *code;
    size_t count;
};

/* Writes a filter's code to a file. Returns 0 or libseccomp's (negative) error. */
static int write_code(enum box_profile profile, bool names, int fd)
{
    struct rules rules = {.refuse = SCMP_ACT_NOTIFY};
    bool run = profile == BOX_RUN;
    if (names)
        rules.context = seccomp_init(run ? rules.refuse : SCMP_ACT_ERRNO(ENOSYS));
    if (!rules.context) {
        rules.refuse = SCMP_ACT_KILL_PROCESS;
        rules.context = seccomp_init(run ? rules.refuse : SCMP_ACT_ERRNO(ENOSYS));
    }
    if (!rules.context)
        return -ENOMEM;
    /* Calls of another architecture (int 0x80, x32): their numbers mean something else. */
    rules.error = seccomp_attr_set(rules.context, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    seccomp_attr_set(rules.context, SCMP_FLTATR_CTL_OPTIMIZE, 2); /* search by halving */
    if (run)
        add_run(&rules);
    else
        add_tools(&rules, profile);
    return rules.error ? rules.error : seccomp_export_bpf(rules.context, fd);
}

/* The same, twice, in a process of its own, which its CPU time bounds: where it gets no memory,
 * libseccomp may turn for ever, or leave a rule out without a word. */
static int write_code_twice(enum box_profile profile, bool names, int fd, struct error *err)
{
    enum { CPU_SECONDS = 10 };
    int status;
    pid_t maker = fork();
    if (maker == 0) {
        setrlimit(RLIMIT_CPU, &(struct rlimit){CPU_SECONDS, CPU_SECONDS});
        int error = write_code(profile, names, fd);
        _exit(-(error ? error : write_code(profile, names, fd)));
    }
    if (maker < 0)
        return error_set(err, "box: cannot start the maker of the seccomp filter: %s",
                         strerror(errno));
    while (waitpid(maker, &status, 0) < 0)
        if (errno != EINTR)
            return error_set(err, "box: cannot wait for the maker of the seccomp filter: %s",
                             strerror(errno));
    if (status == 0)
        return 0;
    return error_set(err, "box: cannot make the seccomp filter (%s %d)",
                     WIFSIGNALED(status) ? "signal" : "libseccomp error",
                     WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status));
}

/* Takes the code that stands twice in a file. */
static int read_code(int fd, struct built *built, struct error *err)
{
    struct stat about;
    if (fstat(fd, &about) < 0)
        return error_set(err, "box: cannot look at the seccomp filter: %s", strerror(errno));
    size_t bytes = (size_t)about.st_size / 2;
    char *code = malloc(2 * bytes);
    if (!code || pread(fd, code, 2 * bytes, 0) != (ssize_t)(2 * bytes) ||
        memcmp(code, code + bytes, bytes) != 0) {
        free(code);
        return error_set(err, "box: no memory for the seccomp filter");
    }
    *built = (struct built){(struct sock_filter *)code, bytes / sizeof(struct sock_filter)};
    return 0;
}

static int build(enum box_profile profile, bool names, struct built *built, struct error *err)
{
    int fd = memfd_create("filter", MFD_CLOEXEC);
    if (fd < 0)
        return error_set(err, "box: cannot make room for the seccomp filter: %s", strerror(errno));
    int failed = write_code_twice(profile, names, fd, err) || read_code(fd, built, err);
    close(fd);
    return failed ? -1 : 0;
}

/* Building takes up to 4 ms, twice what all the rest of a box does, so each kind is built once. The
 * box's process fills its id into its own copy of this memory. */
int filter_build(struct inside *inside, struct error *err)
{
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    static struct built kinds[3][2];
    const struct box_plan *plan = inside->plan;
    bool names = layer_wanted(plan, BOX_SECCOMP_NAMES);
    struct built *kind = &kinds[plan->profile][names];
    int failed = 0;
    if (!layer_wanted(plan, BOX_SECCOMP))
        return 0;
    pthread_mutex_lock(&lock);
    if (!kind->code)
        failed = build(plan->profile, names, kind, err);
    inside->filter = kind->code;
    inside->filter_count = kind->count;
    pthread_mutex_unlock(&lock);
    return failed;
}

static void set_own_id(struct inside *inside)
{
    for (size_t i = 0; i < inside->filter_count; i++) {
        struct sock_filter *at = &inside->filter[i];
        if (at->code == (BPF_JMP | BPF_JEQ | BPF_K) && at->k == OWN_ID_MARK)
            at->k = (uint32_t)getpid();
    }
}

/* Without a listener a refused call must kill by itself. */
static void replace_notification(struct inside *inside)
{
    for (size_t i = 0; i < inside->filter_count; i++) {
        struct sock_filter *at = &inside->filter[i];
        if (at->code == (BPF_RET | BPF_K) && at->k == SECCOMP_RET_USER_NOTIF)
            at->k = SECCOMP_RET_KILL_PROCESS;
    }
}

static long load(const struct inside *inside, unsigned flags)
{
    struct sock_fprog program = {(unsigned short)inside->filter_count, inside->filter};
    return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, flags, &program);
}

int filter_load(struct inside *inside)
{
    struct report *report = &inside->report;
    if (!inside->filter)
        return -1;
    set_own_id(inside);
    long listener = -1;
    /* SPEC_ALLOW: older kernels slow down programs under a filter. */
    if (layer_wanted(inside->plan, BOX_SECCOMP_NAMES)) {
        listener = load(inside, SECCOMP_FILTER_FLAG_SPEC_ALLOW | SECCOMP_FILTER_FLAG_NEW_LISTENER);
        if (listener >= 0) {
            layer_works(report, BOX_SECCOMP_NAMES);
            layer_works(report, BOX_SECCOMP);
            return (int)listener;
        }
        layer_fails(report, BOX_SECCOMP_NAMES, "seccomp listener", errno);
    }
    replace_notification(inside);
    if (load(inside, SECCOMP_FILTER_FLAG_SPEC_ALLOW))
        layer_fails(report, BOX_SECCOMP, "seccomp", errno);
    else
        layer_works(report, BOX_SECCOMP);
    return -1;
}
