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

#include "reference/base/error.h"
#include "reference/base/phrase.h"

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

/* The same for people. */
struct phrase box_layer_title(enum box_layer layer);

/* Why a layer is not active: in both languages, empty where it is. A process that was just cloned
 * hands it to the engine, hence the few bytes. */
struct box_reason {
    char en[80], es[96];
};

/* Plays a machine that lacks some layers: from now on no box of this process has them, each says
 * "switched off" as the reason, and what is refused on such a machine is refused here. For tests;
 * only a caller of the program can ask for it (`--without`), and every result tells.
 *
 * list     names of layers, with commas between: "landlock,cgroup-pids"
 * returns  0, or -1 and *err: no such layer */
int box_switch_off(const char *list, struct error *err) MUST_CHECK;

/* BOX_RUN: a static program that computes; some 50 system calls, no files, no processes.
 * BOX_TOOLS: valgrind or a sanitized program; read-only /usr /lib /lib64 /bin, private /proc and
 * /tmp, no processes. BOX_BUILD: gcc, ld, objcopy; as TOOLS, but with processes and without /proc.
 */
enum box_profile { BOX_RUN, BOX_TOOLS, BOX_BUILD };

enum { BOX_PATH_LIMIT = 16, BOX_PASSED_LIMIT = 8 };

/* What to run, and within which limits. Zero it, then fill it.
 *
 * Inside, `writable` is always the folder /work, so that no output depends on the host's paths, and
 * it is the working folder unless another is named. A BUILD may do there what it likes; TOOLS may
 * only write to the pipes in it, and make files in its folder `tmp` (yours to make and to give by
 * box_give_folder), which with a private root is a small file system of its own and leaves nothing.
 * Without one, Landlock keeps to that, and files in it may be written to. On a machine without mount namespaces there is
 * no /work: the program then starts in the host's folder itself. So name files relative to it
 * ("a.c", "./program"), and the command works on either. */
struct box_plan {
    enum box_profile profile;
    char *const *argv;                    /* argv[0]: path inside the box, unless program_fd */
    char *const *envp;                    /* NULL: PATH=/usr/bin:/bin, LC_ALL=C, TMPDIR */
    int program_fd;                       /* >= 0: run this descriptor, -1: argv[0]; RUN needs one.
                                             The file must be executable by anyone */
    const char *readable[BOX_PATH_LIMIT]; /* further absolute paths visible read-only in their own
                                             places, NULL-terminated; none in RUN */
    const char *covered;          /* TOOLS: an absolute folder below a visible one that shall
                                     look empty but for what `readable` names in it; NULL:
                                     none. Only where there is a private root: without one
                                     it is seen as it is */
    const char *writable;         /* host's folder that becomes /work, or NULL; none in RUN.
                                     Prepare it with box_give_folder */
    const char *working_folder;   /* relative to /work, or absolute; NULL: /work, or / */
    int passed[BOX_PASSED_LIMIT]; /* descriptors that the program gets as 3, 4, 5, ... */
    int passed_count;
    int input_fd, output_fd, error_fd; /* stdio; -1: /dev/null */
    uint64_t memory_bytes;             /* all memory; RUN and BUILD also as address space */
    uint64_t file_bytes;               /* largest file written (stdout included, if a file) */
    uint64_t scratch_bytes;            /* size of the private /tmp, and of /work/tmp */
    uint64_t work_bytes; /* what may stand on the disk in `writable`, looked at now and
                                          then: of a BUILD, and of TOOLS without a private root;
                                          0: not looked at */
    uint64_t stack_bytes;
    unsigned cpu_seconds;     /* of each process; SIGXCPU, and a second later SIGKILL */
    unsigned box_cpu_seconds; /* BUILD: of all processes of the box together, ended ones included;
                                 0: cpu_seconds alone holds */
    unsigned wall_ms;         /* used by box_run only */
    unsigned idle_ms;         /* used by box_run only, BUILD: so long without any CPU time for the
                                 box, and it is killed; 0: not looked at */
    unsigned process_count;   /* BUILD: processes at once; the others never start any */
    int cpu;                  /* pin to this cpu, -1: not */
    uint32_t disabled_layers; /* bit 1 << layer: leave it out (tests, doctor) */
};

/* A running box; fields are read-only for users. To wait for a box and for something else at once,
 * poll `socket` and `notify` (-1: none) for POLLIN, then call box_step. */
struct box {
    pid_t init;
    pid_t program; /* as the engine sees it */
    int pidfd, program_pidfd, socket, notify;
    int work_fd;                               /* of `writable`, -1: none */
    uint32_t active;                           /* bit 1 << layer */
    struct box_reason reason[BOX_LAYER_COUNT]; /* why a layer is not active */
    int landlock_abi, cgroup_version;
    char cgroup_memory[256], cgroup_pids[256], cgroup_cpu[256];
    int64_t start_ns; /* CLOCK_MONOTONIC */
    bool ended;       /* the program is gone; status and usage are known or it was killed */
    /* gathered while running */
    int status; /* wait status, valid when has_status */
    bool has_status;
    bool killed; /* by box_kill */
    bool
        over_memory; /* seen beyond memory_bytes where neither cgroup nor address space bounds it */
    struct rusage usage; /* valid when has_status */
    int64_t cpu_at_kill_ns, watched_ns;
    bool over_disk;           /* seen beyond work_bytes */
    bool over_cpu;            /* all processes together were seen beyond box_cpu_seconds */
    int64_t cpu_seen_ns;      /* BUILD: of all processes together, when last looked at */
    char refused_call[40];    /* name of the first refused system call, empty if none */
    char refused_detail[160]; /* "openat /etc/passwd": what it asked for; untrusted, printable ASCII
                               */
    int refused_count;
    /* from the plan */
    enum box_profile profile;
    unsigned cpu_seconds, box_cpu_seconds;
    uint64_t memory_bytes, work_bytes;
};

/* How a run ended. The first that holds, in this order. */
enum box_end {
    BOX_ENDED_FORBIDDEN, /* a system call was refused: refused_call names it ("" when unnamed) */
    BOX_ENDED_MEMORY,    /* the cgroup's memory limit struck. Without it: TOOLS was seen beyond
                            memory_bytes; a RUN or BUILD gets NULL from malloc instead */
    BOX_ENDED_OUTPUT,    /* SIGXFSZ: file_bytes reached */
    BOX_ENDED_DISK,      /* seen beyond work_bytes, or with thousands of files or folders in folders
                            in folders */
    BOX_ENDED_CPU,       /* cpu_seconds reached (SIGXCPU, or SIGKILL with that much CPU charged), or
                            box_cpu_seconds. A BUILD whose child reaches cpu_seconds says so in
                            words of its own, and exits */
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
    int64_t wall_ns;
    int64_t cpu_ns;             /* of all processes together */
    uint64_t memory_peak_bytes; /* by cgroup, 0: not known */
    uint32_t active;
    struct box_reason reason[BOX_LAYER_COUNT];
    bool cleaned; /* every process gone, cgroups removed */
};

/* Makes the host's folder `path` usable as plan->writable: gives it to the user id that programs in
 * the box have. Only root changes anything (the owner of this one folder); for others that id is
 * their own. Keep the folder inside one of mode 0700, so that no other user reaches it. What the
 * program leaves there is hostile: open it with O_NOFOLLOW and check that it is a regular file.
 * Returns 0, or -1 and *err. */
int box_give_folder(const char *path, struct error *err) MUST_CHECK;

/* Lets programs in the box, and no other user, pass the folder above `path`, which is the caller's
 * own and of mode 0700. Where there is no private root, a program has the host's name, and valgrind
 * reads the symbols of what it runs from the file of that name. Only root changes anything (group
 * and mode of that one folder).
 * Returns 0, or -1 and *err. */
int box_open_way(const char *path, struct error *err) MUST_CHECK;

/* Whether a program in this box, started by root without a private root, cannot pass some folder
 * above `path` (absolute) by the folders' modes; that folder goes to `closed` (PATH_MAX bytes). */
bool box_way_is_closed(const struct box *box, const char *path, char *closed);

/* Starts a program. Returns 0 when the program runs; -1 and *err when the box could not be made or
 * the program not be executed (a fault), and then nothing is left. It is also a fault when
 *   - seccomp or rlimits are not active and the caller did not disable them by name,
 *   - TOOLS or BUILD would see the host's files: neither private root nor Landlock is active, and
 * the caller did not disable both by name,
 *   - the program would run with root's capabilities.
 * Costs about 2 ms. The box ends when the calling thread ends. Do not reap boxes with wait(). */
int box_start(const struct box_plan *plan, struct box *box, struct error *err) MUST_CHECK;

/* Waits at most `timeout_ms` for something to happen and deals with it. A refused call ends the
 * program, except that in RUN what libc itself looks for (locales, charset tables, time zones) is
 * answered ENOENT. Returns true once the program has ended; box_finish must follow. */
bool box_step(struct box *box, int timeout_ms);

/* Kills everything inside, at once. box_finish must follow. */
void box_kill(struct box *box);

/* Ends what still runs, reaps, removes cgroups, closes descriptors, tells how it ended. After this
 * no process of the box exists. */
void box_finish(struct box *box, struct box_outcome *outcome);

/* box_start, box_step until the end, plan->wall_ms or plan->idle_ms, box_finish. After a kill by
 * either outcome->end is BOX_ENDED_KILLED. Returns 0, or -1 and *err as box_start. */
int box_run(const struct box_plan *plan, struct box_outcome *outcome, struct error *err) MUST_CHECK;

/* CPU time that the program has used so far, all threads, read from outside in 0.2 us. Exact while
 * the program sleeps or shares the caller's cpu, else up to a timer tick old. -1 when it is gone.
 */
int64_t box_cpu_ns(const struct box *box);

/* The program's resident memory, to a page and some 64 KiB: box_reset_peak forgets the peak so far,
 * box_peak_resident_bytes reads it since then. Both -1 where /proc does not allow it. */
int box_reset_peak(const struct box *box);
int64_t box_peak_resident_bytes(const struct box *box);

/* Tries each layer for real on this machine: a probe of our own, inside a box with that layer and
 * what it stands on, attempts what the layer forbids. For `doctor`; takes some 100 ms.
 *
 * out      BOX_LAYER_COUNT entries: works or not, one line of reason, one line of remedy (both
 * empty when it works) */
struct box_probe {
    bool works;
    char reason[120];
    char remedy[160];
};
void box_probe_layers(struct box_probe *out);

#endif
