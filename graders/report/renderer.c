/* Starting meshgrade-render; see renderer.h. */
#include "graders/report/renderer.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdint.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

enum { NOTHING_DRAWN = 2, NOT_STARTED = 127 };

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
static const struct phrase out_of_time = {"meshgrade-render did not end in time and was stopped.",
                                          "meshgrade-render no terminó a tiempo y se detuvo."};
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

/* Waits for the end of a child; kills it after limit_ms. Returns whether it ended by itself. */
static bool wait_for(pid_t pid, int limit_ms, int *status)
{
    int fd = (int)syscall(SYS_pidfd_open, pid, 0);
    bool ended = true;
    if (fd >= 0) {
        struct pollfd wait = {.fd = fd, .events = POLLIN};
        int ready;
        do
            ready = poll(&wait, 1, limit_ms);
        while (ready < 0 && errno == EINTR);
        if (ready <= 0) {
            ended = false;
            kill(pid, SIGKILL);
        }
        close(fd);
    }
    while (waitpid(pid, status, 0) < 0 && errno == EINTR)
        continue;
    return ended;
}

int renderer_limit_ms(size_t picture_count)
{
    enum { FIRST_MS = 30000, PICTURE_MS = 10000, MOST_PICTURES = 1000 };
    size_t counted = picture_count < MOST_PICTURES ? picture_count : MOST_PICTURES;
    return FIRST_MS + PICTURE_MS * (int)counted;
}

enum renderer_end renderer_run(const char *program, const char *job_path, int limit_ms,
                               struct phrase *reason)
{
    int status = 0;
    pid_t pid = 0;
    if (!program || start(program, job_path, &pid) != 0) {
        *reason = program ? not_started : renderer_absent_reason();
        return RENDERER_USELESS;
    }
    if (!wait_for(pid, limit_ms, &status)) {
        *reason = out_of_time;
        return RENDERER_FAILED;
    }
    if (WIFSIGNALED(status)) {
        *reason = crashed;
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
