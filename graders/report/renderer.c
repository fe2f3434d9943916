/* Starting meshgrade-render; see renderer.h. */
#include "graders/report/renderer.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdint.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

enum { NOTHING_DRAWN = 2, NOT_STARTED = 127, IDLE_ROUNDS = 60 };

struct phrase renderer_absent_reason(void)
{
    return (struct phrase){
        "the program meshgrade-render is not there (it is built where VTK and OpenImageIO are: "
        "`make deps && make`).",
        "falta el programa meshgrade-render (se construye donde hay VTK y OpenImageIO: "
        "`make deps && make`)."};
}

struct phrase renderer_default_reason(void)
{
    return (struct phrase){"meshgrade-render left some out; run it by hand to see why.",
                           "meshgrade-render dejó algunas; ejecútelo a mano para ver por qué."};
}

static const struct phrase no_gl = {
    "meshgrade-render found no OpenGL on this machine (libegl1 and libgl1-mesa-dri give it one in "
    "software).",
    "meshgrade-render no encontró OpenGL en esta máquina (libegl1 y libgl1-mesa-dri dan uno por "
    "software)."};
static const struct phrase out_of_cpu_time = {
    "meshgrade-render used more CPU time than its pictures can need and was stopped.",
    "meshgrade-render usó más tiempo de CPU del que pueden necesitar sus imágenes y se detuvo."};
static const struct phrase stood_still = {"meshgrade-render stood still and was stopped.",
                                          "meshgrade-render dejó de avanzar y se detuvo."};
static const struct phrase crashed = {"meshgrade-render crashed.", "meshgrade-render se rompió."};
static const struct phrase not_started = {"meshgrade-render could not be started.",
                                          "meshgrade-render no se pudo iniciar."};

static int start(const char *program, const char *job_path, pid_t *pid)
{
    posix_spawn_file_actions_t files;
    if (posix_spawn_file_actions_init(&files) != 0)
        return -1;
    char *const arguments[] = {(char *)(uintptr_t)program, (char *)(uintptr_t)job_path, NULL};
    int status = posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    if (status == 0)
        status = posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
    if (status == 0)
        status = posix_spawn_file_actions_adddup2(&files, 1, 2);
    if (status == 0)
        status = posix_spawn(pid, program, &files, NULL, arguments, environ);
    posix_spawn_file_actions_destroy(&files);
    return status == 0 ? 0 : -1;
}

/* CPU time of a process, all its threads together; negative when it has ended. */
static int64_t cpu_ns_of(pid_t pid)
{
    clockid_t clock;
    struct timespec spent;
    if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &spent) != 0)
        return -1;
    return spent.tv_sec * INT64_C(1000000000) + spent.tv_nsec;
}

/* Waits for the end of a child, and kills it when it has not used the CPU for that long: it waits
 * for something that will not come. One that is kept waiting by other programs gets a little.
 * Returns whether it ended by itself. */
static bool wait_for(pid_t pid, int idle_ms, int *status)
{
    int fd = (int)syscall(SYS_pidfd_open, pid, 0), round_ms = idle_ms / IDLE_ROUNDS + 1;
    bool ended = true;
    int64_t spent_ns = -1;
    for (int idle_rounds = 0; fd >= 0 && ended; idle_rounds++) {
        struct pollfd wait = {.fd = fd, .events = POLLIN};
        if (poll(&wait, 1, round_ms) > 0)
            break;
        int64_t now_ns = cpu_ns_of(pid);
        if (now_ns != spent_ns)
            idle_rounds = 0;
        spent_ns = now_ns;
        ended = idle_rounds < IDLE_ROUNDS;
    }
    if (!ended)
        kill(pid, SIGKILL);
    if (fd >= 0)
        close(fd);
    while (waitpid(pid, status, 0) < 0 && errno == EINTR)
        continue;
    return ended;
}

struct renderer_limits renderer_limits(size_t picture_count)
{
    enum { FIRST_SECONDS = 30, PICTURE_SECONDS = 10, MOST_PICTURES = 1000, IDLE_MS = 60000 };
    size_t counted = picture_count < MOST_PICTURES ? picture_count : MOST_PICTURES;
    return (struct renderer_limits){FIRST_SECONDS + PICTURE_SECONDS * (int)counted, IDLE_MS};
}

/* Why it failed, by how it ended; both NULL: it did not. */
static struct phrase failure_of(int status)
{
    if (!WIFSIGNALED(status))
        return (struct phrase){NULL, NULL};
    return WTERMSIG(status) == SIGXCPU ? out_of_cpu_time : crashed;
}

enum renderer_end renderer_run(const char *program, const char *job_path,
                               struct renderer_limits limits, struct phrase *reason)
{
    int status = 0;
    pid_t pid = 0;
    if (!program || start(program, job_path, &pid) != 0) {
        *reason = program ? not_started : renderer_absent_reason();
        return RENDERER_USELESS;
    }
    const struct rlimit cpu = {(rlim_t)limits.cpu_seconds, (rlim_t)limits.cpu_seconds + 1};
    prlimit(pid, RLIMIT_CPU, &cpu, NULL);
    if (!wait_for(pid, limits.idle_ms, &status)) {
        *reason = stood_still;
        return RENDERER_FAILED;
    }
    if (failure_of(status).en) {
        *reason = failure_of(status);
        return RENDERER_FAILED;
    }
    if (WEXITSTATUS(status) == NOTHING_DRAWN) {
        *reason = no_gl;
        return RENDERER_USELESS;
    }
    if (WEXITSTATUS(status) == NOT_STARTED) {
        *reason = not_started;
        return RENDERER_USELESS;
    }
    return RENDERER_DREW;
}
