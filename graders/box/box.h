/* The box: runs one untrusted program under every protection that this machine grants, and says
 * which ones were really active.
 *
 * Layers: user, pid, mount, net, ipc and uts namespaces; a private root on tmpfs; another user id;
 * no_new_privs; Landlock; a seccomp filter; rlimits; cgroup v1 or v2 limits. Each is tried on its
 * own and reported on its own. Without seccomp nothing is run.
 *
 *   engine --clone--> init of the box --fork--> the program
 *
 * The init (pid 1 of the pid namespace) holds no code of the student, reaps everything, relays the
 * program's wait status and resource usage, and takes everything down with it when it dies. The
 * engine is never blocked by what happens inside: it polls, and kills by pidfd. */
#ifndef GRADERS_BOX_BOX_H
#define GRADERS_BOX_BOX_H

#include "reference/mesh/error.h"

#include <stdbool.h>
#include <stdint.h>
#include <sys/resource.h>
#include <sys/types.h>

enum box_layer {
    BOX_USER_NAMESPACE,
    BOX_PID_NAMESPACE,
    BOX_MOUNT_NAMESPACE,
    BOX_NET_NAMESPACE,
    BOX_IPC_NAMESPACE,
    BOX_UTS_NAMESPACE,
    BOX_PRIVATE_ROOT, /* own minimal read-only root */
    BOX_OTHER_USER,   /* the program's user id is not the engine's */
    BOX_NO_NEW_PRIVILEGES,
    BOX_LANDLOCK,
    BOX_SECCOMP,
    BOX_SECCOMP_NAMES, /* refused calls are named (user notification) */
    BOX_RLIMITS,
    BOX_CGROUP_MEMORY,
    BOX_CGROUP_PIDS,
    BOX_CGROUP_CPU,
    BOX_LAYER_COUNT
};

/* "user-namespace", "landlock", ...: the names in results and in `doctor`. */
const char *box_layer_name(enum box_layer layer);

enum box_profile {
    BOX_RUN, /* a static program that computes: some 50 system calls allowed, no files, no processes
              */
    BOX_TOOLS, /* valgrind or a sanitized program: read-only /usr and /lib, private /proc and /tmp
                */
    BOX_BUILD  /* gcc, ld: as TOOLS, processes allowed, no /proc */
};

enum { BOX_PATH_LIMIT = 16, BOX_PASSED_LIMIT = 8 };

/* What to run, and within which limits. Zero it, then fill it. */
struct box_plan {
    enum box_profile profile;
    char *const *argv;                    /* argv[0]: path inside the box, unless program_fd */
    char *const *envp;                    /* NULL: PATH and LC_ALL=C only */
    int program_fd;                       /* >= 0: run this descriptor (execveat), -1: argv[0] */
    const char *readable[BOX_PATH_LIMIT]; /* absolute paths visible read-only, NULL-terminated */
    const char *writable;         /* absolute path of a folder visible read-write, or NULL */
    const char *working_folder;   /* inside the box; NULL: / */
    int passed[BOX_PASSED_LIMIT]; /* descriptors that the program gets as 3, 4, 5, ... */
    int passed_count;
    int input_fd, output_fd, error_fd; /* stdio; -1: /dev/null */
    uint64_t memory_bytes;             /* all memory; RUN and BUILD also as address space */
    uint64_t file_bytes;               /* largest file written (stdout included, if a file) */
    uint64_t scratch_bytes;            /* size of the private /tmp */
    uint64_t stack_bytes;
    unsigned cpu_seconds;     /* hard limit, whole seconds, rounded up */
    unsigned wall_ms;         /* used by box_run only */
    unsigned process_count;   /* TOOLS, BUILD; RUN never starts any */
    int cpu;                  /* pin to this cpu, -1: not */
    uint32_t disabled_layers; /* bit 1 << layer: leave it out (tests, doctor) */
};

/* A running box; fields are read-only for users. */
struct box {
    pid_t init;
    pid_t program; /* as the engine sees it */
    int pidfd, socket, notify;
    uint32_t active;                  /* bit 1 << layer */
    char reason[BOX_LAYER_COUNT][80]; /* why a layer is not active */
    int landlock_abi, cgroup_version;
    char cgroup_memory[256], cgroup_pids[256], cgroup_cpu[256];
    int64_t start_ns; /* CLOCK_MONOTONIC */
    bool ended;       /* the program is gone; status and usage are known or it was killed */
    /* gathered while running */
    int status; /* wait status, valid when has_status */
    bool has_status;
    struct rusage usage;
    char refused_call[40];    /* name of the first refused system call, empty if none */
    char refused_detail[160]; /* "openat /etc/passwd": what it asked for; untrusted text */
    int refused_count;
};

/* How a run ended. The first that holds, in this order. */
enum box_end {
    BOX_ENDED_FORBIDDEN, /* a system call was refused: refused_call names it ("" when unnamed) */
    BOX_ENDED_MEMORY,    /* the cgroup's memory limit struck */
    BOX_ENDED_OUTPUT,    /* SIGXFSZ: file_bytes reached */
    BOX_ENDED_CPU,       /* cpu_seconds reached (SIGXCPU, or SIGKILL with that much CPU charged) */
    BOX_ENDED_KILLED,    /* by box_kill: the caller knows why (wall time) */
    BOX_ENDED_SIGNAL,    /* died of `signal` */
    BOX_ENDED_EXIT,      /* exited with `exit_code` */
    BOX_ENDED_LOST       /* the box's own init vanished: a fault */
};

struct box_outcome {
    enum box_end end;
    int signal, exit_code;
    char refused_call[40];
    char refused_detail[160];
    bool refused_is_process; /* the refused call would have made a process or thread */
    int64_t wall_ns, cpu_ns;
    uint64_t memory_peak_bytes; /* by cgroup, 0: not known */
    uint32_t active;
    char reason[BOX_LAYER_COUNT][80];
    bool cleaned; /* every process gone, cgroups removed */
};

/* Starts a program. Returns 0; -1 and *err when the box could not be made (a fault; also when
 * seccomp is not active and the caller did not disable it by name), and then nothing is left. */
int box_start(const struct box_plan *plan, struct box *box, struct error *err) MUST_CHECK;

/* Waits at most `timeout_ms` for something to happen and deals with it (a refused call kills the
 * program, except that files below /usr/lib/locale and the like are answered ENOENT).
 * Returns true once the program has ended. */
bool box_step(struct box *box, int timeout_ms);

/* Kills everything inside, at once. box_finish must follow. */
void box_kill(struct box *box);

/* Ends what still runs, reaps, removes cgroups, closes descriptors, tells how it ended. After this
 * no process of the box exists. */
void box_finish(struct box *box, struct box_outcome *outcome);

/* box_start, box_step until the end or plan->wall_ms, box_finish. After a wall-time kill
 * outcome->end is BOX_ENDED_KILLED. Returns 0, or -1 and *err as box_start. */
int box_run(const struct box_plan *plan, struct box_outcome *outcome, struct error *err) MUST_CHECK;

/* Tries each layer for real on this machine, by running a small probe of its own inside a box that
 * attempts what the layer forbids. For `doctor`.
 *
 * out      BOX_LAYER_COUNT entries: works or not, one line of reason, one line of remedy */
struct box_probe {
    bool works;
    char reason[120];
    char remedy[160];
};
void box_probe_layers(struct box_probe *out);

#endif
