/* Runs a judge in a child process; see examine.h.
 *
 * The child writes one file in memory: its judgement, then the scene as JSON. The parent believes
 * it (it is our code) but checks the sizes: the child may have died half way. */
#include "graders/engine/run/examine.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { JUDGE_CPU_SECONDS = 60, EXIT_SAID = 0, EXIT_FAILED = 1 };

struct verdict_message {
    struct judgement judgement;
    struct error err;
};

static bool write_whole(int file, const void *bytes, size_t count)
{
    const char *at = bytes;
    while (count > 0) {
        ssize_t written = write(file, at, count);
        if (written <= 0)
            return false;
        at += written;
        count -= (size_t)written;
    }
    return true;
}

_Noreturn static void judge_and_exit(const struct judge *judge, const struct judge_case *c,
                                     struct span input, struct span answer,
                                     const struct usage *usage, int file)
{
    static struct verdict_message message;
    const struct rlimit cpu = {JUDGE_CPU_SECONDS, JUDGE_CPU_SECONDS}, none = {0, 0};
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setrlimit(RLIMIT_CPU, &cpu);
    setrlimit(RLIMIT_CORE, &none);
    if (judge_case_answer(judge, c, input, answer, usage, &message.judgement, &message.err) != 0) {
        write_whole(file, &message, sizeof message);
        _exit(EXIT_FAILED);
    }
    json_t *scene = message.judgement.accepted || message.judgement.scene.kind == SCENE_NONE
                        ? NULL
                        : scene_to_json(&message.judgement.scene);
    memset(&message.judgement.scene, 0, sizeof message.judgement.scene);
    char *text = scene ? json_dumps(scene, JSON_COMPACT | JSON_REAL_PRECISION(9)) : NULL;
    bool written = write_whole(file, &message, sizeof message) &&
                   (!text || write_whole(file, text, strlen(text)));
    _exit(written ? EXIT_SAID : EXIT_FAILED);
}

static int read_message(int file, struct verdict_message *message, json_t **scene,
                        struct error *err)
{
    off_t size = lseek(file, 0, SEEK_END);
    if (size < (off_t)sizeof *message ||
        pread(file, message, sizeof *message, 0) != (ssize_t)sizeof *message)
        return error_set(err, "the judge said nothing");
    size_t text_bytes = (size_t)size - sizeof *message;
    if (text_bytes == 0)
        return 0;
    char *text = malloc(text_bytes);
    if (text && pread(file, text, text_bytes, sizeof *message) == (ssize_t)text_bytes)
        *scene = json_loadb(text, text_bytes, 0, NULL);
    free(text);
    return *scene ? 0 : error_set(err, "the judge's scene cannot be read");
}

int examine(const struct judge *judge, const struct judge_case *c, struct span input,
            struct span answer, const struct usage *usage, struct examination *examination,
            struct error *err)
{
    struct verdict_message *message = calloc(1, sizeof *message);
    int file = memfd_create("judgement", MFD_CLOEXEC);
    int status = -1, result = -1;
    memset(examination, 0, sizeof *examination);
    fflush(NULL);
    pid_t child = message && file >= 0 ? fork() : -1;
    if (child == 0)
        judge_and_exit(judge, c, input, answer, usage, file);
    if (child < 0) {
        error_set(err, "judge %s: %s", judge->exercise, strerror(errno));
        goto out;
    }
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    if (WIFSIGNALED(status))
        error_set(err, "judge %s: died of signal %d", judge->exercise, WTERMSIG(status));
    else if (read_message(file, message, &examination->scene, err) == 0 &&
             WEXITSTATUS(status) == EXIT_SAID)
        result = 0;
    else
        error_set(err, "judge %s: %s", judge->exercise, message->err.text);
    if (result == 0)
        examination->judgement = message->judgement;
    else
        examination_release(examination);
out:
    free(message);
    if (file >= 0)
        close(file);
    return result;
}

void examination_release(struct examination *examination)
{
    json_decref(examination->scene);
    memset(examination, 0, sizeof *examination);
}
