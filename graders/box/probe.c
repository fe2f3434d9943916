/* Trying each layer for real: in a box with that layer and what it stands on, a probe attempts what
 * the layer forbids. */
#include "graders/box/inside.h"

#include <errno.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

/* No bound: a probe is a copy of the engine, of whatever size that is. */
static const uint64_t large_bytes = UINT64_C(1) << 40;

/* What a probe says of its attempt. */
enum { HELD = 0, PASSED = 1 };

enum { MEMORY_BYTES = 32 << 20, FILE_BYTES = 1 << 20, PROBE_MS = 5000 };

/* What the engine set up outside for the probes to reach for. */
struct bait {
    pid_t engine;
    ino_t mount_namespace, uts_namespace;
    struct sockaddr_in address; /* a listening socket */
    int listener;
    int shared_memory;
    char secret[64]; /* a file that only the engine's user may read */
};

static ino_t namespace_id(const char *path)
{
    struct stat about;
    return stat(path, &about) ? 0 : about.st_ino;
}

static int held_if(bool held)
{
    return held ? HELD : PASSED;
}

static int try_user(const void *bait)
{
    (void)bait;
    return held_if(getuid() == INNER_ID && syscall(SYS_setresuid, 0, 0, 0) &&
                   syscall(SYS_setresuid, 1, 1, 1));
}

static int try_signal_outside(const void *bait)
{
    const struct bait *outside = bait;
    return held_if(kill(outside->engine, 0) && errno == ESRCH);
}

static int try_mounts(const void *bait)
{
    const struct bait *outside = bait;
    return held_if(namespace_id("/proc/self/ns/mnt") != outside->mount_namespace);
}

static int try_host_name(const void *bait)
{
    const struct bait *outside = bait;
    return held_if(namespace_id("/proc/self/ns/uts") != outside->uts_namespace);
}

static int try_connect(const void *bait)
{
    const struct bait *outside = bait;
    int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    return held_if(
        fd < 0 || connect(fd, (const struct sockaddr *)&outside->address, sizeof outside->address));
}

static int try_shared_memory(const void *bait)
{
    const struct bait *outside = bait;
    struct shmid_ds about;
    return held_if(shmctl(outside->shared_memory, IPC_STAT, &about) && errno == EINVAL);
}

static int try_files(const void *bait)
{
    (void)bait;
    return held_if(open("/etc/passwd", O_RDONLY) < 0 &&
                   open("/probe", O_CREAT | O_WRONLY, 0600) < 0);
}

static int try_secret(const void *bait)
{
    const struct bait *outside = bait;
    return held_if(open(outside->secret, O_RDONLY) < 0 && errno == EACCES);
}

static int try_privileges(const void *bait)
{
    (void)bait;
    return held_if(prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) == 1 &&
                   prctl(PR_SET_NO_NEW_PRIVS, 0, 0, 0, 0) != 0);
}

static int try_landlock(const void *bait)
{
    (void)bait;
    return held_if(open("/etc/passwd", O_RDONLY) < 0 && errno == EACCES);
}

static int try_socket(const void *bait)
{
    (void)bait;
    return held_if(socket(AF_INET, SOCK_STREAM, 0) < 0);
}

static int try_large_file(const void *bait)
{
    static const char block[4096];
    (void)bait;
    for (int i = 0; i < 2 * FILE_BYTES / (int)sizeof block; i++)
        if (write(STDOUT_FILENO, block, sizeof block) < 0)
            return HELD;
    return PASSED;
}

static int try_memory(const void *bait)
{
    (void)bait;
    size_t bytes = 2 * (size_t)MEMORY_BYTES;
    volatile char *block =
        mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    for (size_t i = 0; block != MAP_FAILED && i < bytes; i += 4096)
        block[i] = 1;
    return PASSED;
}

static int try_processes(const void *bait)
{
    (void)bait;
    for (int i = 0; i < 4; i++) {
        long pid = syscall(SYS_clone, (long)SIGCHLD, NULL, NULL, NULL, 0L);
        if (pid < 0)
            return held_if(errno == EAGAIN);
        if (pid == 0) {
            pause();
            _exit(0);
        }
    }
    return PASSED;
}

static int use_cpu(const void *bait)
{
    struct timespec used;
    (void)bait;
    do
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    while (used.tv_sec == 0 && used.tv_nsec < 5000000);
    return HELD;
}

#define LAYER(name) (1u << BOX_##name)

static const char allow_namespaces[] = "sysctl user.max_user_namespaces=10000 (Ubuntu: "
                                       "kernel.apparmor_restrict_unprivileged_userns=0); "
                                       "Docker: --security-opt seccomp=unconfined";
static const char allow_groups[] =
    "run as root, or under systemd-run --user --scope -p Delegate=yes; in a container mount "
    "/sys/fs/cgroup writable";
static const char newer_landlock[] = "Linux 5.13 or later with lsm=landlock,... on the kernel's "
                                     "command line; in a container allow landlock_create_ruleset";
static const char allow_filters[] =
    "a kernel with CONFIG_SECCOMP_FILTER; in a container allow seccomp() and prctl()";

/* What each probe tries and which layers it needs besides its own. The user layers stay on, so that
 * no probe runs as root. */
static const struct {
    probe_function *attempt;
    uint32_t with;
    enum box_end end; /* that shows the layer to work; with BOX_ENDED_EXIT the code must be HELD */
    const char *remedy;
} probes[BOX_LAYER_COUNT] = {
    [BOX_USER_NAMESPACE] = {try_user, 0, BOX_ENDED_EXIT, allow_namespaces},
    [BOX_PID_NAMESPACE] = {try_signal_outside, 0, BOX_ENDED_EXIT, allow_namespaces},
    [BOX_MOUNT_NAMESPACE] = {try_mounts, 0, BOX_ENDED_EXIT, allow_namespaces},
    [BOX_NET_NAMESPACE] = {try_connect, 0, BOX_ENDED_EXIT, allow_namespaces},
    [BOX_IPC_NAMESPACE] = {try_shared_memory, 0, BOX_ENDED_EXIT, allow_namespaces},
    [BOX_UTS_NAMESPACE] = {try_host_name, 0, BOX_ENDED_EXIT, allow_namespaces},
    [BOX_PRIVATE_ROOT] = {try_files, LAYER(MOUNT_NAMESPACE), BOX_ENDED_EXIT, allow_namespaces},
    [BOX_OTHER_USER] = {try_secret, 0, BOX_ENDED_EXIT,
                        "only root can give the program another user id; the other layers do not "
                        "need it"},
    [BOX_NO_NEW_PRIVILEGES] = {try_privileges, 0, BOX_ENDED_EXIT, "Linux 3.5 or later"},
    [BOX_LANDLOCK] = {try_landlock, 0, BOX_ENDED_EXIT, newer_landlock},
    [BOX_SECCOMP] = {try_socket, 0, BOX_ENDED_FORBIDDEN, allow_filters},
    [BOX_SECCOMP_NAMES] =
        {try_socket, LAYER(SECCOMP), BOX_ENDED_FORBIDDEN,
         "Linux 5.0 or later, and no container filter with a listener of its own"},
    [BOX_RLIMITS] = {try_large_file, 0, BOX_ENDED_OUTPUT, "allow setrlimit"},
    [BOX_CGROUP_MEMORY] = {try_memory, 0, BOX_ENDED_MEMORY, allow_groups},
    [BOX_CGROUP_PIDS] = {try_processes, LAYER(PID_NAMESPACE), BOX_ENDED_EXIT, allow_groups},
    [BOX_CGROUP_CPU] = {use_cpu, 0, BOX_ENDED_EXIT, allow_groups},
};

static void lay_bait(struct bait *bait)
{
    socklen_t length = sizeof bait->address;
    bait->engine = getpid();
    bait->mount_namespace = namespace_id("/proc/self/ns/mnt");
    bait->uts_namespace = namespace_id("/proc/self/ns/uts");
    bait->address.sin_family = AF_INET;
    bait->address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    bait->listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (bait->listener >= 0 &&
        (bind(bait->listener, (struct sockaddr *)&bait->address, length) ||
         listen(bait->listener, 1) ||
         getsockname(bait->listener, (struct sockaddr *)&bait->address, &length))) {
        close(bait->listener);
        bait->listener = -1;
    }
    bait->shared_memory = shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0666);
    snprintf(bait->secret, sizeof bait->secret, "/tmp/meshgrade-probe-XXXXXX");
    int fd = mkstemp(bait->secret); /* mode 0600 */
    if (fd >= 0)
        close(fd);
}

static void remove_bait(const struct bait *bait)
{
    if (bait->listener >= 0)
        close(bait->listener);
    if (bait->shared_memory >= 0)
        shmctl(bait->shared_memory, IPC_RMID, NULL);
    unlink(bait->secret);
}

static struct box_plan plan_of(enum box_layer layer, char *const *argv, int output)
{
    uint32_t on = 1u << layer | probes[layer].with | LAYER(OTHER_USER) | LAYER(NO_NEW_PRIVILEGES);
    if (layer != BOX_OTHER_USER)
        on |= LAYER(USER_NAMESPACE);
    return (struct box_plan){.profile = BOX_RUN,
                             .argv = argv,
                             .program_fd = output, /* never executed */
                             .input_fd = -1,
                             .output_fd = output,
                             .error_fd = -1,
                             .memory_bytes =
                                 layer == BOX_CGROUP_MEMORY ? MEMORY_BYTES : large_bytes,
                             .file_bytes = FILE_BYTES,
                             .stack_bytes = 8 << 20,
                             .scratch_bytes = 1 << 20,
                             .cpu_seconds = 2,
                             .cpu = -1,
                             .disabled_layers = ~on};
}

static void say(struct box_probe *out, const char *reason)
{
    snprintf(out->reason, sizeof out->reason, "%.*s", (int)sizeof out->reason - 1, reason);
}

/* Whether the outcome shows that the layer works. */
static bool judge(enum box_layer layer, const struct box_outcome *outcome)
{
    if (outcome->end != probes[layer].end)
        return false;
    if (layer == BOX_SECCOMP_NAMES)
        return strcmp(outcome->refused_call, "socket") == 0;
    if (layer == BOX_CGROUP_CPU)
        return outcome->cpu_ns >= 4000000;
    return outcome->end != BOX_ENDED_EXIT || outcome->exit_code == HELD;
}

static void probe_layer(enum box_layer layer, const struct bait *bait, struct box_probe *out)
{
    char name[] = "probe";
    char *const argv[] = {name, NULL};
    struct error err = {""};
    struct box box;
    struct box_outcome outcome;
    int output = memfd_create("probe", MFD_CLOEXEC);
    struct box_plan plan = plan_of(layer, argv, output);
    if (start_with_probe(&plan, probes[layer].attempt, bait, &box, &err)) {
        say(out, err.text);
    } else {
        for (int waited_ms = 0; !box_step(&box, 100) && waited_ms < PROBE_MS; waited_ms += 100)
            ;
        box_finish(&box, &outcome);
        out->works = box.active >> layer & 1 && judge(layer, &outcome);
        if (!out->works)
            say(out, outcome.reason[layer].en[0] ? outcome.reason[layer].en
                                                 : "active, but it let pass what it must stop");
    }
    if (output >= 0)
        close(output);
    if (!out->works)
        snprintf(out->remedy, sizeof out->remedy, "%s", probes[layer].remedy);
}

void box_probe_layers(struct box_probe *out)
{
    struct bait bait = {.listener = -1, .shared_memory = -1};
    memset(out, 0, BOX_LAYER_COUNT * sizeof *out);
    lay_bait(&bait);
    for (int layer = 0; layer < BOX_LAYER_COUNT; layer++)
        probe_layer((enum box_layer)layer, &bait, &out[layer]);
    remove_bait(&bait);
}
