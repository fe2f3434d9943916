/* A running box: steps, killing, the end and its name. */
#include "graders/box/box.h"

#include "graders/box/inside.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <string.h>
#include <sys/pidfd.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
    WATCH_MS = 10,        /* how often memory is looked at where nothing bounds it */
    TREE_WATCH_MS = 100,  /* and the CPU time of a build's processes */
    DEATH_LIMIT_MS = 5000 /* after SIGKILL */
};

static bool is_active(const struct box *box, enum box_layer layer)
{
    return box->active >> layer & 1;
}

/* Only builds have several processes. */
static bool has_tree(const struct box *box)
{
    return box->profile == BOX_BUILD;
}

static void look_at_tree(struct box *box)
{
    int64_t cpu_ns = cgroup_cpu_ns(box);
    if (cpu_ns < 0)
        cpu_ns = tree_cpu_ns(box);
    if (cpu_ns > box->cpu_seen_ns)
        box->cpu_seen_ns = cpu_ns;
}

static void end_processes(struct box *box)
{
    int64_t cpu_ns = box_cpu_ns(box);
    if (has_tree(box) && !box->has_status) {
        look_at_tree(box);
        cpu_ns = box->cpu_seen_ns;
    }
    if (cpu_ns > box->cpu_at_kill_ns)
        box->cpu_at_kill_ns = cpu_ns;
    /* With a pid namespace, init takes all others with it. Without one it must live, to reap them.
     */
    if (is_active(box, BOX_PID_NAMESPACE) || box->program_pidfd < 0) {
        if (box->pidfd >= 0)
            pidfd_send_signal(box->pidfd, SIGKILL, NULL, 0);
    } else {
        pidfd_send_signal(box->program_pidfd, SIGKILL, NULL, 0);
        cgroup_kill(box);
    }
}

void box_kill(struct box *box)
{
    box->killed = true;
    end_processes(box);
}

/* Takes init's last message, if there. Returns true when nothing more can come. */
static bool take_report(struct box *box)
{
    struct report report;
    ssize_t got = recv(box->socket, &report, sizeof report, MSG_DONTWAIT);
    if (got < 0 && (errno == EAGAIN || errno == EINTR))
        return false;
    if (got == (ssize_t)sizeof report && report.kind == REPORT_EXIT) {
        box->status = report.status;
        box->usage = report.usage;
        box->has_status = true;
    }
    return true;
}

/* Tools reserve address space without end, so that only what is resident can be bounded. */
static bool needs_watch(const struct box *box)
{
    return !is_active(box, BOX_CGROUP_MEMORY) &&
           (box->profile == BOX_TOOLS || !is_active(box, BOX_RLIMITS));
}

static void watch_memory(struct box *box)
{
    int64_t bytes = measure_resident_bytes(box);
    if (bytes > 0 && (uint64_t)bytes > box->memory_bytes) {
        box->over_memory = true;
        end_processes(box);
        box->ended = true;
    }
}

static void watch_tree(struct box *box)
{
    look_at_tree(box);
    if (box->box_cpu_seconds == 0 || box->cpu_seen_ns < box->box_cpu_seconds * INT64_C(1000000000))
        return;
    box->over_cpu = true;
    end_processes(box);
    box->ended = true;
}

/* The host's own folder is bounded by nothing else. */
static bool needs_disk_watch(const struct box *box)
{
    return box->work_bytes && box->work_fd >= 0 &&
           (has_tree(box) || !is_active(box, BOX_PRIVATE_ROOT));
}

static void watch_disk(struct box *box)
{
    if (disk_bytes(box) <= (int64_t)box->work_bytes)
        return;
    box->over_disk = true;
    end_processes(box);
    box->ended = true;
}

/* How often to look at what nothing else bounds; 0: never. */
static int watch_ms(const struct box *box)
{
    if (has_tree(box))
        return TREE_WATCH_MS;
    return needs_watch(box) || needs_disk_watch(box) ? WATCH_MS : 0;
}

static void watch(struct box *box)
{
    int64_t now = measure_now_ns();
    if (now - box->watched_ns < watch_ms(box) * INT64_C(1000000) / 2)
        return;
    box->watched_ns = now;
    if (needs_watch(box))
        watch_memory(box);
    if (has_tree(box) && !box->ended)
        watch_tree(box);
    if (needs_disk_watch(box) && !box->ended)
        watch_disk(box);
}

/* Returns whether something happened within `timeout_ms`. */
static bool wait_once(struct box *box, int timeout_ms)
{
    struct pollfd ready[2] = {{box->socket, POLLIN, 0}, {box->notify, POLLIN, 0}};
    if (poll(ready, 2, timeout_ms) <= 0) /* a negative descriptor is passed over */
        return false;
    if (ready[1].revents & POLLIN) {
        if (refusal_take(box)) {
            end_processes(box);
            box->ended = true;
            return true;
        }
    } else if (ready[1].revents) { /* nobody is under the filter any more */
        close(box->notify);
        box->notify = -1;
    }
    if (ready[0].revents && take_report(box))
        box->ended = true;
    return true;
}

bool box_step(struct box *box, int timeout_ms)
{
    int64_t end_ns = measure_now_ns() + timeout_ms * INT64_C(1000000);
    int every_ms = watch_ms(box);
    while (!box->ended) {
        int64_t left_ns = end_ns - measure_now_ns();
        int left_ms = left_ns > 0 ? (int)((left_ns + 999999) / 1000000) : 0;
        if (every_ms)
            watch(box);
        if (box->ended || wait_once(box, every_ms && left_ms > every_ms ? every_ms : left_ms) ||
            left_ms == 0)
            break;
    }
    return box->ended;
}

/* Waits until init is gone. Returns true when it is. */
static bool await_init(const struct box *box, int timeout_ms)
{
    struct pollfd gone = {box->pidfd, POLLIN, 0};
    int64_t end_ns = measure_now_ns() + timeout_ms * INT64_C(1000000);
    int polled;
    do {
        int64_t left_ms = (end_ns - measure_now_ns()) / 1000000;
        polled = poll(&gone, 1, left_ms > 0 ? (int)left_ms : 0);
    } while (polled < 0 && errno == EINTR);
    return polled == 1;
}

static bool reap_init(struct box *box)
{
    siginfo_t info;
    if (box->pidfd < 0)
        return true;
    if (!box->has_status)
        end_processes(box);
    bool gone = await_init(box, DEATH_LIMIT_MS);
    if (!gone) {
        pidfd_send_signal(box->pidfd, SIGKILL, NULL, 0);
        gone = await_init(box, DEATH_LIMIT_MS);
    }
    if (gone)
        while (waitid(P_PIDFD, (id_t)box->pidfd, &info, WEXITED) < 0 && errno == EINTR)
            ;
    return gone;
}

static void close_fd(int *fd)
{
    if (*fd >= 0)
        close(*fd);
    *fd = -1;
}

bool box_release(struct box *box)
{
    bool gone = reap_init(box);
    if (!is_active(box, BOX_PID_NAMESPACE))
        cgroup_kill(box);
    bool removed = cgroup_remove(box);
    close_fd(&box->notify);
    close_fd(&box->socket);
    close_fd(&box->work_fd);
    close_fd(&box->program_pidfd);
    close_fd(&box->pidfd);
    box->ended = true;
    return gone && removed;
}

static int64_t usage_ns(const struct rusage *usage)
{
    return (usage->ru_utime.tv_sec + usage->ru_stime.tv_sec) * INT64_C(1000000000) +
           (usage->ru_utime.tv_usec + usage->ru_stime.tv_usec) * INT64_C(1000);
}

static int64_t total_cpu_ns(const struct box *box)
{
    int64_t cpu_ns = cgroup_cpu_ns(box);
    if (cpu_ns < 0)
        cpu_ns = box->has_status ? usage_ns(&box->usage) : box->cpu_at_kill_ns;
    return cpu_ns > box->cpu_seen_ns ? cpu_ns : box->cpu_seen_ns;
}

static bool ran_out_of_cpu(const struct box *box, int64_t cpu_ns)
{
    bool used_up = cpu_ns >= box->cpu_seconds * INT64_C(1000000000);
    if (box->over_cpu)
        return true;
    if (has_tree(box)) /* what all used together tells nothing of the limit of each */
        return box->has_status && WIFSIGNALED(box->status) && WTERMSIG(box->status) == SIGXCPU;
    if (!box->has_status)
        return box->killed && used_up;
    return WIFSIGNALED(box->status) &&
           (WTERMSIG(box->status) == SIGXCPU || (WTERMSIG(box->status) == SIGKILL && used_up));
}

static enum box_end name_end(const struct box *box, uint64_t oom_kills, int64_t cpu_ns)
{
    bool signalled = box->has_status && WIFSIGNALED(box->status);
    int signal_number = signalled ? WTERMSIG(box->status) : 0;
    if (box->refused_count || (signal_number == SIGSYS && is_active(box, BOX_SECCOMP)))
        return BOX_ENDED_FORBIDDEN;
    if (oom_kills || box->over_memory)
        return BOX_ENDED_MEMORY;
    if (signal_number == SIGXFSZ)
        return BOX_ENDED_OUTPUT;
    if (box->over_disk)
        return BOX_ENDED_DISK;
    if (ran_out_of_cpu(box, cpu_ns))
        return BOX_ENDED_CPU;
    if (box->killed && (!box->has_status || signal_number == SIGKILL))
        return BOX_ENDED_KILLED;
    if (!box->has_status)
        return BOX_ENDED_LOST;
    return signalled ? BOX_ENDED_SIGNAL : BOX_ENDED_EXIT;
}

void box_finish(struct box *box, struct box_outcome *outcome)
{
    memset(outcome, 0, sizeof *outcome);
    outcome->wall_ns = measure_now_ns() - box->start_ns;
    if (!box->ended) /* it may have ended unseen */
        box_step(box, 0);
    bool gone = reap_init(box);
    if (!box->has_status)
        take_report(box);
    uint64_t oom_kills = cgroup_oom_kills(box);
    outcome->memory_peak_bytes = cgroup_peak_bytes(box);
    outcome->cpu_ns = total_cpu_ns(box);
    outcome->end = name_end(box, oom_kills, outcome->cpu_ns);
    if (box->has_status && WIFSIGNALED(box->status))
        outcome->signal = WTERMSIG(box->status);
    if (box->has_status && WIFEXITED(box->status))
        outcome->exit_code = WEXITSTATUS(box->status);
    memcpy(outcome->refused_call, box->refused_call, sizeof outcome->refused_call);
    memcpy(outcome->refused_detail, box->refused_detail, sizeof outcome->refused_detail);
    outcome->refused_is_process = refusal_is_process(box->refused_call);
    outcome->active = box->active;
    memcpy(outcome->reason, box->reason, sizeof outcome->reason);
    outcome->cleaned = box_release(box) && gone;
}

/* Since when a box has got no CPU time. */
struct rest {
    int64_t cpu_ns, since_ns;
};

static bool rests_too_long(const struct box_plan *plan, const struct box *box, struct rest *rest)
{
    int64_t now_ns = measure_now_ns();
    if (box->cpu_seen_ns > rest->cpu_ns)
        *rest = (struct rest){box->cpu_seen_ns, now_ns};
    return plan->idle_ms && now_ns - rest->since_ns > plan->idle_ms * INT64_C(1000000);
}

int box_run(const struct box_plan *plan, struct box_outcome *outcome, struct error *err)
{
    struct box box;
    if (box_start(plan, &box, err))
        return -1;
    int64_t end_ns = box.start_ns + plan->wall_ms * INT64_C(1000000);
    struct rest rest = {0, box.start_ns};
    for (;;) {
        int64_t left_ns = end_ns - measure_now_ns();
        int step_ms = left_ns > 0 ? (int)(left_ns / 1000000) + 1 : 0;
        if (plan->idle_ms && step_ms > TREE_WATCH_MS)
            step_ms = TREE_WATCH_MS;
        if (box_step(&box, step_ms))
            break;
        if (left_ns <= 0 || rests_too_long(plan, &box, &rest)) {
            box_kill(&box);
            break;
        }
    }
    box_finish(&box, outcome);
    return 0;
}
