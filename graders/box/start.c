/* Starting a box: everything is made ready, init is cloned, mapped and put into its groups, and the
 * program's first words are awaited. */
#include "graders/box/inside.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/pidfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

/* A box comes up in 2 ms; this much later the machine has stalled. */
enum { START_LIMIT_MS = 30000 };

/* Whether programs get a user id of their own, unless the kernel refuses it. */
static bool gives_other_user(void)
{
    static const struct box_plan any;
    return geteuid() == 0 && layer_wanted(&any, BOX_OTHER_USER);
}

int box_give_folder(const char *path, struct error *err)
{
    struct stat about;
    int fd = open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (fd < 0)
        return error_set(err, "%s: cannot open the folder: %s", path, strerrordesc_np(errno));
    int failed = 0;
    /* EINVAL: a container that has no such user; there the program keeps the engine's own. */
    if (gives_other_user() && fchown(fd, SPARE_ID, SPARE_ID) && errno != EINVAL)
        failed = error_set(err, "%s: cannot give the folder to the box: %s", path,
                           strerrordesc_np(errno));
    else if (fstat(fd, &about) || (about.st_mode & S_IRWXU) != S_IRWXU)
        failed = error_set(err, "%s: its owner must be able to read, write and enter it", path);
    close(fd);
    return failed;
}

int box_open_way(const char *path, struct error *err)
{
    char above[PATH_MAX];
    struct stat about;
    if (!gives_other_user())
        return 0;
    if (snprintf(above, sizeof above, "%s/..", path) >= PATH_MAX)
        return error_set(err, "%s: the path is too long", path);
    int fd = open(above, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    /* EINVAL: as above. */
    int failed = fd < 0 || (fchown(fd, (uid_t)-1, SPARE_ID) && errno != EINVAL) ||
                 fstat(fd, &about) || fchmod(fd, (about.st_mode & 07777) | S_IXGRP);
    if (failed)
        error_set(err, "%s: cannot let programs in boxes pass: %s", above, strerrordesc_np(errno));
    if (fd >= 0)
        close(fd);
    return failed ? -1 : 0;
}

bool box_way_is_closed(const struct box *box, const char *path, char *closed)
{
    struct stat about;
    bool by_name = !(box->active >> BOX_PRIVATE_ROOT & 1) && box->active >> BOX_OTHER_USER & 1;
    for (const char *slash = strchr(path + 1, '/'); by_name && slash;
         slash = strchr(slash + 1, '/')) {
        snprintf(closed, PATH_MAX, "%.*s", (int)(slash - path), path);
        if (stat(closed, &about) == 0 && !(about.st_mode & S_IXOTH) &&
            !(about.st_gid == SPARE_ID && about.st_mode & S_IXGRP))
            return true;
    }
    return false;
}

static int check_plan(const struct box_plan *plan, struct error *err)
{
    if ((unsigned)plan->profile > BOX_BUILD)
        return error_set(err, "box: unknown profile");
    if (plan->passed_count < 0 || plan->passed_count > BOX_PASSED_LIMIT)
        return error_set(err, "box: %d descriptors to pass, at most %d", plan->passed_count,
                         BOX_PASSED_LIMIT);
    if (!plan->argv || !plan->argv[0])
        return error_set(err, "box: no program named");
    if (plan->profile == BOX_RUN && plan->program_fd < 0)
        return error_set(err, "box: a run needs its program as a descriptor");
    if (plan->profile == BOX_RUN && (plan->readable[0] || plan->writable))
        return error_set(err, "box: a run sees no files, but the plan names some");
    for (int i = 0; i < BOX_PATH_LIMIT && plan->readable[i]; i++)
        if (plan->readable[i][0] != '/' || plan->readable[i][1] == '\0')
            return error_set(err, "box: readable path %s must be absolute", plan->readable[i]);
    if (plan->covered && (plan->profile != BOX_TOOLS || plan->covered[0] != '/'))
        return error_set(err, "box: covered folder %s: only of tools, and absolute", plan->covered);
    if (plan->writable && plan->writable[0] != '/')
        return error_set(err, "box: writable path %s must be absolute", plan->writable);
    if (!plan->cpu_seconds || !plan->memory_bytes || !plan->stack_bytes)
        return error_set(err, "box: the limits of CPU, memory and stack must not be 0");
    return 0;
}

static int open_channels(struct inside *inside, struct error *err)
{
    int notes[2], init[2], one = 1;
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, notes))
        return error_set(err, "box: socketpair: %s", strerrordesc_np(errno));
    inside->engine_notes = notes[0];
    inside->notes = notes[1];
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, init))
        return error_set(err, "box: socketpair: %s", strerrordesc_np(errno));
    inside->engine_init = init[0];
    inside->init = init[1];
    /* The kernel tells the sender's process id as the engine sees it. */
    setsockopt(inside->engine_notes, SOL_SOCKET, SO_PASSCRED, &one, sizeof one);
    inside->null_fd = open("/dev/null", O_RDWR | O_CLOEXEC);
    if (inside->null_fd < 0)
        return error_set(err, "box: /dev/null: %s", strerrordesc_np(errno));
    return 0;
}

static void close_fd(int *fd)
{
    if (*fd >= 0)
        close(*fd);
    *fd = -1;
}

static int open_inside(struct inside *inside, const struct box_plan *plan, struct error *err)
{
    inside->plan = plan;
    if (check_plan(plan, err) || open_channels(inside, err))
        return -1;
    if (plan->writable) {
        inside->work_fd = open(plan->writable, O_PATH | O_DIRECTORY | O_CLOEXEC);
        if (inside->work_fd < 0)
            return error_set(err, "box: %s: %s", plan->writable, strerrordesc_np(errno));
    }
    for (int layer = 0; layer < BOX_LAYER_COUNT; layer++)
        if (!layer_wanted(plan, (enum box_layer)layer))
            layer_lacks(&inside->report, (enum box_layer)layer,
                        (struct phrase){"switched off", "desactivada"});
    root_plan(inside);
    /* Where the engine's root may not do it, init tries as well, and says why not. */
    if (geteuid() == 0 && layer_wanted(plan, BOX_PRIVATE_ROOT) && root_take_trees(inside))
        root_close_trees(inside);
    return filter_build(inside, err);
}

static void close_inside(struct inside *inside)
{
    root_close_trees(inside);
    close_fd(&inside->engine_notes);
    close_fd(&inside->engine_init);
    close_fd(&inside->notes);
    close_fd(&inside->init);
    close_fd(&inside->null_fd);
    close_fd(&inside->work_fd);
}

static void read_control(struct msghdr *message, struct box *box)
{
    for (struct cmsghdr *at = CMSG_FIRSTHDR(message); at; at = CMSG_NXTHDR(message, at)) {
        if (at->cmsg_level != SOL_SOCKET)
            continue;
        if (at->cmsg_type == SCM_RIGHTS)
            memcpy(&box->notify, CMSG_DATA(at), sizeof box->notify);
        if (at->cmsg_type == SCM_CREDENTIALS) {
            struct ucred sender;
            memcpy(&sender, CMSG_DATA(at), sizeof sender);
            box->program = sender.pid;
        }
    }
}

/* Receives a report from the program, or from init when that failed before there was a program.
 * Returns its size, 0 at the end of the channel, -1 on silence. */
static ssize_t receive(struct inside *inside, struct box *box, struct report *report)
{
    union {
        char bytes[256];
        struct cmsghdr header;
    } control;
    struct iovec part = {report, sizeof *report};
    struct msghdr message = {.msg_iov = &part,
                             .msg_iovlen = 1,
                             .msg_control = control.bytes,
                             .msg_controllen = sizeof control.bytes};
    struct pollfd ready = {inside->engine_notes, POLLIN, 0};
    int polled;
    do
        polled = poll(&ready, 1, START_LIMIT_MS);
    while (polled < 0 && errno == EINTR);
    if (polled != 1)
        return -1;
    ssize_t got = recvmsg(inside->engine_notes, &message, MSG_CMSG_CLOEXEC | MSG_DONTWAIT);
    if (got == (ssize_t)sizeof *report)
        read_control(&message, box);
    return got;
}

/* The engine knows of the groups and mapped the user; the program knows of the rest. */
static void merge(struct box *box, const struct report *report)
{
    uint32_t groups = 1u << BOX_CGROUP_MEMORY | 1u << BOX_CGROUP_PIDS | 1u << BOX_CGROUP_CPU;
    box->active = (box->active & groups) | (report->active & ~groups);
    for (int layer = 0; layer < BOX_LAYER_COUNT; layer++)
        if (!(groups >> layer & 1) || !box->reason[layer].en[0])
            box->reason[layer] = report->reason[layer];
    box->landlock_abi = report->landlock_abi;
}

static int await_program(struct inside *inside, struct box *box, struct error *err)
{
    struct report *report = &inside->report;
    ssize_t got = receive(inside, box, report);
    if (got == 0 &&
        recv(inside->engine_init, report, sizeof *report, MSG_DONTWAIT) == (ssize_t)sizeof *report)
        got = sizeof *report;
    if (got != (ssize_t)sizeof *report)
        return error_set(err, "box: its init ended or stalled without a word");
    if (report->kind != REPORT_READY)
        return error_set(err, "box: %s", report->failure);
    merge(box, report);
    box->program_pidfd = pidfd_open(box->program, 0);
    if (inside->probe)
        return 0;
    /* exec closes the program's end; anything else is a word of failure. */
    got = receive(inside, box, report);
    if (got == 0)
        return 0;
    if (got == (ssize_t)sizeof *report && report->kind == REPORT_FAILED)
        return error_set(err, "box: %s", report->failure);
    return error_set(err, "box: the program did not start");
}

/* The kernel, short of memory, shall end the box before it ends the engine. */
static void offer_to_oom(const struct box *box)
{
    char folder[32];
    snprintf(folder, sizeof folder, "/proc/%d", box->init);
    text_put(folder, "oom_score_adj", "1000");
}

static int launch(struct inside *inside, struct box *box, struct error *err)
{
    if (namespaces_spawn(inside, box, err))
        return -1;
    close_fd(&inside->notes);
    close_fd(&inside->init);
    cgroup_join(box);
    offer_to_oom(box);
    char go = inside->other_user ? 'o' : 's';
    if (send(inside->engine_init, &go, 1, MSG_NOSIGNAL) != 1)
        return error_set(err, "box: its init ended before it began");
    return await_program(inside, box, err);
}

int start_with_probe(const struct box_plan *plan, probe_function *probe, const void *argument,
                     struct box *box, struct error *err)
{
    memset(box, 0, sizeof *box);
    box->pidfd = box->program_pidfd = box->socket = box->notify = box->work_fd = -1;
    box->profile = plan->profile;
    box->cpu_seconds = plan->cpu_seconds;
    box->box_cpu_seconds = plan->box_cpu_seconds;
    box->memory_bytes = plan->memory_bytes;
    box->work_bytes = plan->work_bytes;
    struct inside *inside = calloc(1, sizeof *inside);
    if (!inside)
        return error_set(err, "box: out of memory");
    inside->engine_notes = inside->engine_init = inside->notes = inside->init = -1;
    inside->null_fd = inside->work_fd = -1;
    inside->probe = probe;
    inside->probe_argument = argument;
    int failed = open_inside(inside, plan, err);
    if (!failed) {
        cgroup_make(plan, box);
        failed = launch(inside, box, err);
    }
    if (failed) {
        box_release(box);
    } else {
        box->work_fd = inside->work_fd;
        inside->work_fd = -1;
        box->socket = inside->engine_init;
        inside->engine_init = -1;
        box->start_ns = measure_now_ns();
    }
    close_inside(inside);
    free(inside);
    return failed;
}

int box_start(const struct box_plan *plan, struct box *box, struct error *err)
{
    return start_with_probe(plan, NULL, NULL, box, err);
}
