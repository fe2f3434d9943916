/* A worker process seen from the side that asks; see process.h. */
#include "bench/measure/process.h"

#include "bench/measure/clock.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

struct process process_none(void)
{
    return (struct process){.to = -1, .from = -1};
}

static void become(const char *const *argv, const char *const *environment, int in, int out)
{
    int null = open("/dev/null", O_WRONLY | O_CLOEXEC);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (int i = 0; environment && environment[i]; i++)
        putenv((char *)(uintptr_t)environment[i]); /* putenv's argument was never const */
    if (dup2(in, 0) >= 0 && dup2(out, 1) >= 0 && null >= 0 && dup2(null, 2) >= 0)
        execv(argv[0], (char *const *)(uintptr_t)argv);
    _exit(127);
}

int process_start(struct process *process, const char *const *argv, const char *const *environment,
                  struct error *err)
{
    int in[2], out[2];
    *process = process_none();
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, in) != 0) /* see tell */
        return error_set(err, "no pipe: %s", strerror(errno));
    if (pipe2(out, O_CLOEXEC) != 0) {
        close(in[0]);
        close(in[1]);
        return error_set(err, "no pipe: %s", strerror(errno));
    }
    pid_t pid = fork();
    if (pid == 0)
        become(argv, environment, in[0], out[1]);
    close(in[0]);
    close(out[1]);
    process->to = in[1];
    process->from = out[0];
    process->pid = pid > 0 ? pid : 0;
    if (pid > 0)
        return 0;
    process_stop(process, 0);
    return error_set(err, "no process: %s", strerror(errno));
}

/* Waits until the process has ended; false when it has not within `seconds`. */
static bool wait_for_end(pid_t pid, int seconds, int *status)
{
    int64_t deadline = clock_wall_ns() + (int64_t)seconds * 1000000000;
    while (waitpid(pid, status, WNOHANG) == 0) {
        if (clock_wall_ns() > deadline)
            return false;
        nanosleep(&(struct timespec){.tv_nsec = 500000}, NULL);
    }
    return true;
}

static int tell_end(struct process *process, struct error *err)
{
    int status = 0;
    pid_t pid = process->pid;
    process->pid = 0;
    if (!wait_for_end(pid, 1, &status)) {
        kill(pid, SIGKILL);
        waitpid(pid, &status, 0);
        return error_set(err, "the worker closed its output");
    }
    if (WIFSIGNALED(status))
        return error_set(err, "the worker died of signal %d (%s)", WTERMSIG(status),
                         strsignal(WTERMSIG(status)));
    if (WEXITSTATUS(status) == 127)
        return error_set(err, "the worker could not be started");
    return error_set(err, "the worker ended with %d", WEXITSTATUS(status));
}

/* Moves the first whole line of what was read to process->line. */
static bool take_line(struct process *process)
{
    char *end = memchr(process->rest, '\n', (size_t)process->rest_length);
    if (!end)
        return false;
    int length = (int)(end - process->rest);
    memcpy(process->line, process->rest, (size_t)length);
    process->line[length] = '\0';
    process->rest_length -= length + 1;
    memmove(process->rest, end + 1, (size_t)process->rest_length);
    return true;
}

int process_read(struct process *process, int seconds, struct error *err)
{
    int64_t deadline = clock_wall_ns() + (int64_t)seconds * 1000000000;
    if (!process->pid)
        return error_set(err, "the worker has ended before");
    while (!take_line(process)) {
        struct pollfd wait = {.fd = process->from, .events = POLLIN};
        int64_t left_ms = (deadline - clock_wall_ns()) / 1000000;
        if (process->rest_length == PROCESS_LINE_CAPACITY)
            return error_set(err, "the worker answered with too long a line");
        if (left_ms <= 0)
            return error_set(err, "the worker did not answer within %d s", seconds);
        if (poll(&wait, 1, (int)(left_ms < 1000 ? left_ms : 1000)) <= 0)
            continue;
        ssize_t got = read(process->from, process->rest + process->rest_length,
                           (size_t)(PROCESS_LINE_CAPACITY - process->rest_length));
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return tell_end(process, err);
        process->rest_length += (int)got;
    }
    return 0;
}

/* A worker that died is an error here, not a signal: signals are the program's, not ours. A pipe
 * would have no way to ask for that. */
static bool tell(int to, const char *bytes, size_t count)
{
    ssize_t sent;
    do
        sent = send(to, bytes, count, MSG_NOSIGNAL);
    while (sent < 0 && errno == EINTR);
    return sent == (ssize_t)count;
}

int process_ask(struct process *process, const char *verb, const char *name, int seconds,
                struct error *err)
{
    char line[PROCESS_LINE_CAPACITY];
    int length = snprintf(line, sizeof line, "%s %s\n", verb, name);
    if (!process->pid)
        return error_set(err, "the worker has ended before");
    if (length >= (int)sizeof line)
        return error_set(err, "too long a line for a worker");
    if (!tell(process->to, line, (size_t)length))
        return tell_end(process, err);
    return process_read(process, seconds, err);
}

bool process_stop(struct process *process, int seconds)
{
    int status = 0;
    pid_t pid = process->pid;
    if (process->to >= 0)
        close(process->to);
    if (process->from >= 0)
        close(process->from);
    *process = process_none();
    if (pid == 0)
        return true;
    if (!wait_for_end(pid, seconds, &status)) {
        kill(pid, SIGKILL);
        waitpid(pid, &status, 0);
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}
