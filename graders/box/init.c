/* The box's init: pid 1 of its pid namespace. It prepares what the program will see, starts it,
 * reaps everything, and tells the engine how the program ended. It runs no code of a student; when
 * it dies, its namespace dies with it. */
#include "graders/box/inside.h"

#include <errno.h>
#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

static _Noreturn void fail(struct inside *inside, const char *what, int error)
{
    struct report *report = &inside->report;
    report->kind = REPORT_FAILED;
    snprintf(report->failure, sizeof report->failure, "%s: %s", what, strerrordesc_np(error));
    send(inside->init, report, sizeof *report, MSG_NOSIGNAL);
    _exit(1);
}

/* Raw system calls, here and wherever glibc would take a lock or act on all threads: another thread
 * of the engine may have held a glibc lock at the clone, and in this process nobody would ever
 * release it. */
static void reset_signals(void)
{
    static const uint64_t by_default[4]; /* handler, flags, restorer, mask: all 0 */
    for (int number = 1; number < NSIG; number++)
        syscall(SYS_rt_sigaction, number, by_default, NULL, sizeof(uint64_t));
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
}

/* Moves one descriptor above all slots; -1 stays -1. */
static void lift(struct inside *inside, int *fd)
{
    if (*fd < 0)
        return;
    int high = fcntl(*fd, F_DUPFD_CLOEXEC, SLOT_FREE);
    if (high < 0)
        fail(inside, "descriptor limit below 400", errno);
    *fd = high;
}

static void place(struct inside *inside, int fd, int slot, int flags)
{
    if (fd >= 0 && dup3(fd, slot, flags) < 0)
        fail(inside, "dup3", errno);
}

/* Leaves exactly the program's descriptors and the slots open: nothing else of the engine's. */
static void arrange_descriptors(struct inside *inside)
{
    const struct box_plan *plan = inside->plan;
    int program = plan->program_fd;
    int standard[3] = {plan->input_fd, plan->output_fd, plan->error_fd};
    int passed[BOX_PASSED_LIMIT];
    memcpy(passed, plan->passed, sizeof passed);
    lift(inside, &inside->init);
    for (int i = 0; i < 3; i++) {
        if (standard[i] < 0)
            standard[i] = inside->null_fd;
        lift(inside, &standard[i]);
    }
    for (int i = 0; i < plan->passed_count; i++)
        lift(inside, &passed[i]);
    for (int i = 0; i < inside->tree_count; i++)
        lift(inside, &inside->trees[i].fd);
    lift(inside, &program);
    lift(inside, &inside->notes);
    lift(inside, &inside->work_fd);

    close_range(0, SLOT_FREE - 1, 0);
    for (int i = 0; i < 3; i++)
        place(inside, standard[i], i, 0);
    for (int i = 0; i < plan->passed_count; i++)
        place(inside, passed[i], 3 + i, 0);
    place(inside, program, SLOT_PROGRAM, O_CLOEXEC);
    place(inside, inside->notes, SLOT_NOTES, O_CLOEXEC);
    place(inside, inside->init, SLOT_INIT, O_CLOEXEC);
    place(inside, inside->work_fd, SLOT_WORK, O_CLOEXEC);
    for (int i = 0; i < inside->tree_count; i++) {
        place(inside, inside->trees[i].fd, SLOT_TREE + i, O_CLOEXEC);
        inside->trees[i].fd = inside->trees[i].fd < 0 ? -1 : SLOT_TREE + i;
    }
    close_range(SLOT_FREE, ~0u, 0);
    inside->notes = SLOT_NOTES;
    inside->init = SLOT_INIT;
    inside->work_fd = inside->work_fd < 0 ? -1 : SLOT_WORK;
}

/* The engine's descriptor leads into the engine's mount namespace, and has no path in ours: where
 * no private root will hide the folder, a shell that starts in it would complain. This early the
 * user is still the engine's, who may pass all folders above. If not, it stays as it is. */
static void reopen_work(const struct inside *inside)
{
    if (!(inside->namespaces & CLONE_NEWNS) || inside->work_fd < 0)
        return;
    int own = open(inside->plan->writable, O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (own < 0)
        return;
    dup3(own, SLOT_WORK, O_CLOEXEC);
    close(own);
}

/* Waits until the engine has mapped users and set cgroups; it says whether the user is another. */
static void await_go(struct inside *inside)
{
    char go = 0;
    if (recv(inside->init, &go, 1, 0) != 1)
        _exit(1);
    inside->other_user = go == 'o';
}

/* Groups first: after the user id is gone nothing else can be changed. */
static int take_user(uint32_t id)
{
    return syscall(SYS_setresgid, id, id, id) || syscall(SYS_setresuid, id, id, id) ? -1 : 0;
}

static int drop_groups(void)
{
    return (int)syscall(SYS_setgroups, 0L, NULL);
}

/* Inside a user namespace: keeps the capabilities, which reach no further than the namespace. */
static void become_inner_user(struct inside *inside)
{
    if (getuid() != INNER_ID) {
        if (drop_groups() && errno != EPERM)
            fail(inside, "setgroups", errno);
        if (take_user(INNER_ID))
            fail(inside, "setresuid", errno);
    }
    if (inside->other_user)
        layer_works(&inside->report, BOX_OTHER_USER);
    else if (layer_wanted(inside->plan, BOX_OTHER_USER))
        layer_lacks(&inside->report, BOX_OTHER_USER,
                    (struct phrase){"the engine has no second user id to give (it is not root)",
                                    "el corrector no tiene otro usuario que dar (no es root)"});
}

/* Without a user namespace: root gives up its id for good. */
static void drop_user(struct inside *inside)
{
    if (!layer_wanted(inside->plan, BOX_OTHER_USER))
        return;
    if (geteuid() != 0)
        layer_lacks(&inside->report, BOX_OTHER_USER,
                    (struct phrase){"the engine is not root", "el corrector no es root"});
    else if (drop_groups() || take_user(SPARE_ID))
        layer_fails(&inside->report, BOX_OTHER_USER, "setresuid", errno);
    else
        layer_works(&inside->report, BOX_OTHER_USER);
}

/* Each change of the user id takes this back, and the engine may have died meanwhile. */
static void end_with_engine(const struct inside *inside)
{
    char byte;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (recv(inside->init, &byte, 1, MSG_DONTWAIT | MSG_PEEK) == 0)
        _exit(1);
}

static pid_t fork_program(struct inside *inside)
{
    pid_t pid = (pid_t)syscall(SYS_clone, (long)SIGCHLD, NULL, NULL, NULL, 0L);
    if (pid == 0)
        program_main(inside);
    if (pid < 0)
        fail(inside, "fork", errno);
    return pid;
}

/* Sends a signal to each process of a list of ids. */
static void signal_each(const char *list, int number)
{
    char *end;
    for (const char *at = list;; at = end) {
        long pid = strtol(at, &end, 10);
        if (end == at)
            return;
        if (pid > 1)
            kill((pid_t)pid, number);
    }
}

/* Without a pid namespace nobody else ends what the program left behind. Stopping all before
 * killing any keeps them from forking on meanwhile. Bounded: the engine ends a worse case by its
 * cgroup. */
static void end_orphans(void)
{
    for (int round = 0; round < 1000; round++) {
        char children[4096];
        while (waitpid(-1, NULL, WNOHANG) > 0)
            ;
        if (text_get("/proc/thread-self", "children", children, sizeof children) <= 0)
            return;
        signal_each(children, SIGSTOP);
        signal_each(children, SIGKILL);
    }
}

static void reap_until(struct inside *inside, pid_t program)
{
    struct report *report = &inside->report;
    pid_t gone;
    do {
        gone = waitpid(-1, &report->status, 0);
        if (gone < 0 && errno != EINTR)
            fail(inside, "waitpid", errno);
    } while (gone != program);
}

_Noreturn void init_main(struct inside *inside)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    reset_signals();
    umask(022);
    arrange_descriptors(inside);
    reopen_work(inside);
    await_go(inside);
    if (inside->namespaces & CLONE_NEWUSER)
        become_inner_user(inside);
    root_enter(inside);
    if (!(inside->namespaces & CLONE_NEWUSER))
        drop_user(inside);
    prctl(PR_SET_DUMPABLE, 0);
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    end_with_engine(inside);

    pid_t program = fork_program(inside);
    close(SLOT_NOTES); /* now only the program holds it: its end tells the engine of the exec */
    close_range(0, SLOT_NOTES - 1, 0);
    reap_until(inside, program);
    if (!(inside->namespaces & CLONE_NEWPID))
        end_orphans();
    getrusage(RUSAGE_CHILDREN, &inside->report.usage);
    inside->report.kind = REPORT_EXIT;
    send(inside->init, &inside->report, sizeof inside->report, MSG_NOSIGNAL);
    _exit(0);
}
