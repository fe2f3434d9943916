/* Clones the box's init into its own namespaces: all of them where the machine grants it, else as
 * many as it does. */
#include "graders/box/inside.h"

#include <errno.h>
#include <linux/sched.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

static const struct {
    enum box_layer layer;
    uint64_t flag;
} kinds[] = {
    {BOX_USER_NAMESPACE, CLONE_NEWUSER}, {BOX_PID_NAMESPACE, CLONE_NEWPID},
    {BOX_MOUNT_NAMESPACE, CLONE_NEWNS},  {BOX_NET_NAMESPACE, CLONE_NEWNET},
    {BOX_IPC_NAMESPACE, CLONE_NEWIPC},   {BOX_UTS_NAMESPACE, CLONE_NEWUTS},
};

enum { KIND_COUNT = sizeof kinds / sizeof kinds[0] };

static uint64_t wanted_flags(const struct box_plan *plan)
{
    uint64_t flags = 0;
    for (size_t i = 0; i < KIND_COUNT; i++)
        if (layer_wanted(plan, kinds[i].layer))
            flags |= kinds[i].flag;
    return flags;
}

/* Not glibc's fork: that takes locks which another thread of the engine may hold for ever. */
static pid_t clone_process(uint64_t flags, int *pidfd)
{
    struct clone_args arguments = {
        .flags = flags | CLONE_PIDFD, .pidfd = (uint64_t)(uintptr_t)pidfd, .exit_signal = SIGCHLD};
    pid_t pid = (pid_t)syscall(SYS_clone3, &arguments, sizeof arguments);
    if (pid < 0 && errno == ENOSYS) /* containers refuse clone3, whose flags a filter cannot see */
        pid =
            (pid_t)syscall(SYS_clone, (long)(flags | CLONE_PIDFD | SIGCHLD), NULL, pidfd, NULL, 0L);
    return pid;
}

static void record_namespaces(struct inside *inside, uint64_t flags, int error)
{
    uint64_t wanted = wanted_flags(inside->plan);
    inside->namespaces = flags;
    for (size_t i = 0; i < KIND_COUNT; i++) {
        if (flags & kinds[i].flag)
            layer_works(&inside->report, kinds[i].layer);
        else if (wanted & kinds[i].flag)
            layer_fails(&inside->report, kinds[i].layer, "clone", error);
    }
}

/* Maps the inner user to `outer_user`, `outer_group`. Returns 0, or -1 with errno. */
static int write_maps(pid_t pid, uint32_t outer_user, uint32_t outer_group, bool deny_groups)
{
    char folder[32], line[64];
    snprintf(folder, sizeof folder, "/proc/%d", pid);
    if (deny_groups && text_put(folder, "setgroups", "deny"))
        return -1;
    snprintf(line, sizeof line, "%d %u 1", INNER_ID, outer_user);
    if (text_put(folder, "uid_map", line))
        return -1;
    snprintf(line, sizeof line, "%d %u 1", INNER_ID, outer_group);
    return text_put(folder, "gid_map", line);
}

static int map_user(struct inside *inside, pid_t pid)
{
    inside->other_user = geteuid() == 0 && layer_wanted(inside->plan, BOX_OTHER_USER) &&
                         write_maps(pid, SPARE_ID, SPARE_ID, false) == 0;
    if (inside->other_user)
        return 0;
    return write_maps(pid, geteuid(), getegid(), true);
}

static void give_up(struct box *box)
{
    siginfo_t info;
    kill(box->init, SIGKILL);
    while (waitid(P_PIDFD, (id_t)box->pidfd, &info, WEXITED) < 0 && errno == EINTR)
        ;
    close(box->pidfd);
    box->init = 0;
    box->pidfd = -1;
}

/* One try. Returns 0, or -1 with errno. */
static int spawn_with(struct inside *inside, struct box *box, uint64_t flags)
{
    pid_t pid = clone_process(flags, &box->pidfd);
    if (pid < 0)
        return -1;
    if (pid == 0) {
        init_main(inside);
    }
    box->init = pid;
    if (flags & CLONE_NEWUSER && map_user(inside, pid)) {
        int error = errno;
        give_up(box);
        errno = error;
        return -1;
    }
    return 0;
}

int namespaces_spawn(struct inside *inside, struct box *box, struct error *err)
{
    uint64_t all = wanted_flags(inside->plan);
    uint64_t without_user = geteuid() == 0 ? all & ~(uint64_t)CLONE_NEWUSER : 0;
    uint64_t tries[] = {all, all & ~(uint64_t)CLONE_NEWNET, without_user, 0};
    int error = 0, spawned = -1;
    sigset_t every, before;
    sigfillset(&every);
    pthread_sigmask(SIG_SETMASK, &every,
                    &before); /* no handler of the engine may run in the child */
    for (size_t i = 0; i < sizeof tries / sizeof tries[0] && spawned; i++) {
        record_namespaces(inside, tries[i], error);
        spawned = spawn_with(inside, box, tries[i]);
        if (spawned && !error)
            error = errno;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    if (spawned)
        return error_set(err, "box: cannot clone a process: %s", strerrordesc_np(error));
    return 0;
}
