/* Calls a program in a box over shared memory; see session.h. */
#include "graders/engine/run/session.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/futex.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

enum {
    OUTPUT_LIMIT_BYTES = 1 << 20,
    STACK_BYTES = 16 << 20,
    SCRATCH_BYTES = 64 << 20,
    WAIT_NS = 2000000,
    QUIT_STEP_MS = 10,
    LATE_NS = 50000000
};

static int64_t now_ns(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * 1000000000LL + time.tv_nsec;
}

/* Time that the program was ready to run and had no CPU, from /proc/<pid>/schedstat. */
static int64_t waiting_ns(pid_t pid)
{
    char path[64], text[128] = "";
    snprintf(path, sizeof path, "/proc/%d/schedstat", (int)pid);
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return 0;
    ssize_t count = read(file, text, sizeof text - 1);
    close(file);
    if (count <= 0)
        return 0;
    char *rest;
    strtoll(text, &rest, 10);
    return strtoll(rest, NULL, 10);
}

/* Whether the program would work if the machine let it: it has or waits for a CPU (R), or waits for
 * a disk (D), as the letter behind its name in /proc/<pid>/stat tells. */
static bool is_held_up(pid_t pid)
{
    char path[64], text[512];
    snprintf(path, sizeof path, "/proc/%d/stat", (int)pid);
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return false;
    ssize_t count = read(file, text, sizeof text - 1);
    close(file);
    text[count > 0 ? count : 0] = '\0';
    const char *name_end = strrchr(text, ')'); /* the name may hold anything */
    return name_end && (strncmp(name_end, ") R", 3) == 0 || strncmp(name_end, ") D", 3) == 0);
}

/* ------------------------------------------------------------------- start */

static int make_output(struct session *session, struct error *err)
{
    session->output.fd = memfd_create("output", MFD_CLOEXEC);
    if (session->output.fd < 0)
        return error_set(err, "output file: %s", strerror(errno));
    return 0;
}

static void fill_box_plan(const struct session *session, const struct session_plan *plan,
                          struct box_plan *box)
{
    *box = (struct box_plan){
        .profile = plan->profile,
        .argv = plan->argv,
        .envp = plan->envp,
        .program_fd = plan->program_fd,
        .writable = plan->work_folder,
        .covered = plan->covered,
        .readable = {plan->uncovered},
        .passed = {session->control_region.fd, plan->input->fd, session->answer.fd},
        .passed_count = 3,
        .input_fd = -1,
        .output_fd = session->output.fd,
        .error_fd = session->output.fd,
        .memory_bytes = plan->memory_limit_bytes,
        .file_bytes = plan->profile == BOX_RUN ? OUTPUT_LIMIT_BYTES : 16 * OUTPUT_LIMIT_BYTES,
        .scratch_bytes = SCRATCH_BYTES,
        .work_bytes = SCRATCH_BYTES,
        .stack_bytes = STACK_BYTES,
        .cpu_seconds = plan->cpu_seconds,
        .process_count = 8,
        .cpu = plan->cpu,
    };
    static char name[] = "submission";
    static char *const nameless[] = {name, NULL};
    if (!box->argv)
        box->argv = nameless;
}

int session_start(struct session *session, const struct session_plan *plan, struct error *err)
{
    struct box_plan box;
    memset(session, 0, sizeof *session);
    session->control_region.fd = session->answer.fd = session->output.fd = -1;
    if (region_make(&session->control_region, CONTROL_BYTES, false, err) != 0 ||
        region_make(&session->answer, plan->answer_bytes, false, err) != 0 ||
        make_output(session, err) != 0)
        goto failed;
    session->control = (struct control *)session->control_region.bytes;
    session->control->input_capacity = plan->input->capacity;
    session->control->answer_capacity = session->answer.capacity;
    session->control->mode = plan->mode;
    atomic_store(&session->control->done_index, NOT_READY);
    session->control->heap_limit_bytes =
        plan->heap_limit_bytes ? (uint64_t)plan->heap_limit_bytes : INT64_MAX / 2;
    session->meanwhile = plan->meanwhile;
    session->meanwhile_argument = plan->meanwhile_argument;
    session->budget = plan->budget;
    session->ends_by_itself = plan->ends_by_itself;
    fill_box_plan(session, plan, &box);
    if (box_start(&box, &session->box, err) != 0)
        goto failed;
    session->alive = true;
    return 0;
failed:
    session_release(session);
    return -1;
}

/* -------------------------------------------------------------------- call */

static void futex_wake(_Atomic uint32_t *word)
{
    syscall(SYS_futex, word, FUTEX_WAKE, 1, NULL, NULL, 0);
}

static void futex_wait(_Atomic uint32_t *word, uint32_t value)
{
    struct timespec limit = {0, WAIT_NS};
    syscall(SYS_futex, word, FUTEX_WAIT, value, &limit, NULL, 0);
}

static bool is_done(const struct session *session)
{
    return atomic_load(&session->control->done_index) == session->call_index;
}

/* The box's own process tells how the program ended; on a busy machine that takes it a while. */
static const int64_t GONE_NS = 60000000000LL;

/* How long the program has been waited for, as of the last look. */
struct wait {
    const struct call_limits *limits;
    int64_t looked_ns, used_ns, waited_ns; /* by the clock; its CPU time; without a CPU */
    int64_t idle_ns;
    int64_t gone_ns; /* when the program was first seen to be gone, 0: not */
};

static struct wait begin_wait(struct session *session, const struct call_limits *limits)
{
    return (struct wait){
        limits, now_ns(), box_cpu_ns(&session->box), waiting_ns(session->box.program), 0, 0};
}

/* Whether the program has ended, reaped or not. */
static bool is_gone(const struct session *session)
{
    struct pollfd end = {session->box.program_pidfd, POLLIN, 0};
    return end.fd >= 0 && poll(&end, 1, 0) == 1;
}

/* Adds what went by since the last look and was neither work nor the machine's doing. Looks are
 * taken every few milliseconds: one that comes late tells of a busy machine, not of the program. */
static void add_idle_time(const struct session *session, struct wait *wait, int64_t now_ns,
                          int64_t used_ns, int64_t waited_ns)
{
    int64_t idle_ns =
        now_ns - wait->looked_ns - (used_ns - wait->used_ns) - (waited_ns - wait->waited_ns);
    if (idle_ns > LATE_NS)
        idle_ns = LATE_NS;
    if (idle_ns > 0 && !is_held_up(session->box.program))
        wait->idle_ns += idle_ns;
    wait->looked_ns = now_ns;
    wait->used_ns = used_ns;
    wait->waited_ns = waited_ns;
}

/* What ends the wait when a limit is passed, else CALL_ANSWERED. */
static enum call_end passed_limit(const struct session *session, struct wait *wait)
{
    int64_t now = now_ns(), used_ns = box_cpu_ns(&session->box);
    int64_t waited_ns = waiting_ns(session->box.program);
    if (is_gone(session) || used_ns < 0 || waited_ns < wait->waited_ns) { /* its clocks, too */
        if (wait->gone_ns == 0)
            wait->gone_ns = now;
        return now - wait->gone_ns > GONE_NS ? CALL_IDLE : CALL_ANSWERED;
    }
    add_idle_time(session, wait, now, used_ns, waited_ns);
    if (used_ns - session->cpu_start_ns > wait->limits->cpu_ns)
        return CALL_CPU;
    if (wait->idle_ns > wait->limits->idle_ns)
        return CALL_IDLE;
    return budget_is_spent(session->budget, used_ns - session->taken_cpu_ns + wait->idle_ns)
               ? CALL_SPENT
               : CALL_ANSWERED;
}

/* Takes from the budget what the session has used and what it was idle. */
static void take_from_budget(struct session *session, int64_t used_ns, int64_t idle_ns)
{
    if (used_ns < session->taken_cpu_ns) /* it is gone, and its clock with it */
        used_ns = session->taken_cpu_ns;
    budget_take(session->budget, used_ns - session->taken_cpu_ns, idle_ns);
    session->taken_cpu_ns = used_ns;
}

static void work_meanwhile(const struct session *session)
{
    if (session->meanwhile)
        session->meanwhile(session->meanwhile_argument);
}

static enum call_end await_within(struct session *session, struct wait *wait)
{
    for (;;) {
        futex_wait(&session->control->done_index, session->call_index - 1);
        work_meanwhile(session);
        if (is_done(session))
            return CALL_ANSWERED;
        if (box_step(&session->box, 0))
            return is_done(session) ? CALL_ANSWERED : CALL_DIED;
        enum call_end passed = passed_limit(session, wait);
        if (passed != CALL_ANSWERED)
            return passed;
    }
}

/* Waits for the call; on anything but CALL_ANSWERED the program is dead or being killed. */
static enum call_end await(struct session *session, const struct call_limits *limits)
{
    struct wait wait = begin_wait(session, limits);
    enum call_end end = await_within(session, &wait);
    take_from_budget(session, box_cpu_ns(&session->box), wait.idle_ns);
    return end;
}

/* Starting takes seconds under a tool on a busy machine. */
static const struct call_limits ready_limits = {60000000000LL, 60000000000LL};

enum call_end session_await_ready(struct session *session)
{
    if (session->is_ready && !budget_is_spent(session->budget, 0))
        return CALL_ANSWERED;
    session->cpu_start_ns = 0;
    enum call_end end =
        budget_is_spent(session->budget, 0) ? CALL_SPENT : await(session, &ready_limits);
    session->is_ready = end == CALL_ANSWERED;
    if (session->is_ready)
        return CALL_ANSWERED;
    session->alive = false;
    box_kill(&session->box);
    return end == CALL_SPENT ? CALL_SPENT : CALL_NOT_READY;
}

static uint64_t fresh_nonce(void)
{
    uint64_t nonce = 0;
    if (getrandom(&nonce, sizeof nonce, 0) != sizeof nonce || nonce == 0)
        nonce = (uint64_t)now_ns() | 1;
    return nonce;
}

enum call_end session_call(struct session *session, size_t input_bytes, int64_t failing_allocation,
                           const struct call_limits *limits)
{
    struct control *control = session->control;
    uint64_t nonce = fresh_nonce();
    enum call_end end = session_await_ready(session);
    if (end != CALL_ANSWERED)
        return end;
    control->nonce = nonce;
    control->echo = 0;
    control->input_bytes = input_bytes;
    control->input_page = session->input_page;
    control->failing_allocation = failing_allocation;
    session->cpu_start_ns = box_cpu_ns(&session->box);
    atomic_store(&control->call_index, ++session->call_index);
    futex_wake(&control->call_index);
    end = await(session, limits);
    memcpy(&session->claims, (const void *)control, sizeof session->claims);
    if (end == CALL_ANSWERED && session->claims.echo != nonce)
        end = CALL_DIED; /* it said "done" without having gone through the runner */
    if (end == CALL_ANSWERED) {
        session->call_cpu_ns = box_cpu_ns(&session->box) - session->cpu_start_ns;
    } else {
        session->alive = false;
        box_kill(&session->box);
    }
    return end;
}

/* --------------------------------------------------------------------- end */

static const struct call_limits quit_limits = {5000000000LL, 5000000000LL};

/* Lets the program end by itself; kills it when it will not. The budget does not matter here: what
 * a measurement rests on shall not be lost at its very end. */
static void quit(struct session *session)
{
    session->cpu_start_ns = box_cpu_ns(&session->box);
    struct wait wait = begin_wait(session, &quit_limits);
    atomic_store(&session->control->call_index, CALL_QUIT);
    futex_wake(&session->control->call_index);
    while (!box_step(&session->box, QUIT_STEP_MS)) {
        work_meanwhile(session);
        enum call_end passed = passed_limit(session, &wait);
        if (passed == CALL_CPU || passed == CALL_IDLE) {
            box_kill(&session->box);
            break;
        }
    }
    budget_take(session->budget, 0, wait.idle_ns);
}

int session_end(struct session *session, struct box_outcome *outcome, struct error *err)
{
    if (session->alive && session->ends_by_itself)
        quit(session);
    else if (session->alive)
        box_kill(&session->box);
    session->alive = false;
    box_finish(&session->box, outcome);
    take_from_budget(session, outcome->cpu_ns, 0);
    if (outcome->end == BOX_ENDED_LOST)
        return error_set(err, "the box's own process vanished");
    return 0;
}

size_t session_output(const struct session *session, char *text, size_t capacity)
{
    struct stat status;
    ssize_t count = pread(session->output.fd, text, capacity - 1, 0);
    text[count > 0 ? count : 0] = '\0';
    return fstat(session->output.fd, &status) == 0 ? (size_t)status.st_size : 0;
}

void session_release(struct session *session)
{
    region_release(&session->control_region);
    region_release(&session->answer);
    if (session->output.fd >= 0)
        close(session->output.fd);
    session->output.fd = -1;
}
