/* Grades a class with child processes; see classroom.h. */
#include "graders/engine/classroom.h"

#include "reference/base/plural.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

enum { JOBS_MAX = 64, TRIES = 2 };

/* ---------------------------------------------------------- one submission */

static struct source *sources_of(const struct upload *upload)
{
    struct source *sources = calloc((size_t)upload->file_count + 1, sizeof *sources);
    for (int i = 0; sources && i < upload->file_count; i++)
        sources[i] = (struct source){upload->files[i].name, (const char *)upload->files[i].bytes,
                                     upload->files[i].count};
    return sources;
}

int grade_submission(struct yardstick *yardstick, const struct upload *upload,
                     const struct trial_scope *scope, struct outcome *outcome, struct error *err)
{
    struct submitter submitter = {upload->student, upload->student_folder};
    struct source *sources = sources_of(upload);
    struct trial trial = {0};
    *outcome = (struct outcome){NULL, NULL};
    if (!sources)
        return error_set(err, "out of memory");
    int result =
        trial_run(&trial, yardstick, upload->student, sources, upload->file_count, scope, err);
    if (result == 0)
        result = score_trial(&trial, &submitter, outcome, err);
    if (result != 0)
        outcome_release(outcome);
    trial_release(&trial);
    free(sources);
    return result;
}

/* -------------------------------------------------------------------- jobs */

/* A child at work on one upload. */
struct job {
    pid_t pid; /* 0: free */
    int pidfd, file;
    int lesson, upload;
    int try;
};

/* The child hands back {"result": ..., "scenes": text} or {"fault": text}. */
_Noreturn static void work(struct yardstick *yardstick, const struct upload *upload,
                           const struct trial_scope *scope, int file)
{
    struct outcome outcome;
    struct error err = {""};
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    json_t *message =
        grade_submission(yardstick, upload, scope, &outcome, &err) == 0
            ? json_pack("{s:o, s:s}", "result", outcome.result, "scenes", outcome.scenes)
            : json_pack("{s:s}", "fault", err.text);
    FILE *stream = fdopen(file, "w"); /* jansson writes and reads descriptors a byte at a time */
    bool written = message && stream && json_dumpf(message, stream, JSON_COMPACT) == 0;
    _exit(written && fclose(stream) == 0 ? 0 : 1);
}

static int start_job(const struct classroom *classroom, struct job *job,
                     struct yardstick *yardstick, struct error *err)
{
    const struct upload *upload = &classroom->uploads->uploads[job->upload];
    const struct trial_scope scope = {
        .left_out = classroom->left_out ? classroom->left_out[job->upload] : 0};
    job->file = memfd_create("outcome", MFD_CLOEXEC);
    fflush(NULL);
    job->pid = job->file >= 0 ? fork() : -1;
    if (job->pid == 0)
        work(yardstick, upload, &scope, job->file);
    if (job->pid < 0) {
        job->pid = 0;
        return error_set(err, "cannot start a worker: %s", strerror(errno));
    }
    job->pidfd = (int)syscall(SYS_pidfd_open, job->pid, 0);
    return job->pidfd >= 0 ? 0 : error_set(err, "cannot watch a worker: %s", strerror(errno));
}

/* Reaps a job; gives its outcome, or its fault as text. */
static void finish_job(struct job *job, struct outcome *outcome, struct error *fault)
{
    int status;
    while (waitpid(job->pid, &status, 0) < 0 && errno == EINTR)
        continue;
    FILE *stream = fdopen(job->file, "r");
    json_t *message = NULL;
    if (stream) {
        rewind(stream);
        message = json_loadf(stream, 0, NULL);
    }
    const char *scenes = json_string_value(json_object_get(message, "scenes"));
    *outcome = (struct outcome){json_incref(json_object_get(message, "result")),
                                scenes ? strdup(scenes) : NULL};
    const char *text = json_string_value(json_object_get(message, "fault"));
    fault->text[0] = '\0';
    if (text)
        error_set(fault, "%s", text);
    else if (!outcome->result)
        error_set(fault, "the worker ended with status %d before it had a result", status);
    json_decref(message);
    if (job->pidfd >= 0)
        close(job->pidfd);
    if (stream)
        fclose(stream);
    else
        close(job->file);
    job->pid = 0;
}

/* ------------------------------------------------------------------- class */

static void digest_of(const struct upload *upload, char digest[STORE_DIGEST])
{
    struct source *sources = sources_of(upload);
    store_digest(sources, sources ? upload->file_count : 0, upload->refusal.message.en, digest);
    free(sources);
}

static void note_change(struct classroom *classroom, const struct upload *upload,
                        const json_t *before, const json_t *after)
{
    if (before && json_equal(before, after))
        return;
    json_array_append_new(classroom->changes,
                          json_pack("{s:s, s:s, s:O, s:O}", "student", upload->student, "exercise",
                                    upload->exercise ? upload->exercise : "unknown", "before",
                                    before ? before : json_null(), "after", after));
}

static int keep_outcome(struct classroom *classroom, const struct upload *upload,
                        const struct outcome *outcome, struct error *err)
{
    char digest[STORE_DIGEST];
    const char *exercise = upload->exercise ? upload->exercise : "unknown";
    bool store = true;
    digest_of(upload, digest);
    if (classroom->regrade) {
        json_t *before;
        if (store_find(classroom->store, upload->student_folder, exercise, NULL, &before, err) != 0)
            return -1;
        note_change(classroom, upload, before, outcome->result);
        json_decref(before);
        store = classroom->apply;
    }
    if (store &&
        store_put(classroom->store, upload->student_folder, exercise, digest, outcome, err) != 0)
        return -1;
    classroom->done++;
    if (classroom->progress)
        classroom->progress(classroom, outcome->result, classroom->done, classroom->total);
    return 0;
}

/* A submission that never runs: refused at upload, or faulted twice. */
static int keep_without_trial(struct classroom *classroom, const struct exercise *exercise,
                              const struct upload *upload, enum verdict verdict,
                              const struct refusal *why, struct error *err)
{
    struct outcome outcome;
    struct submitter submitter = {upload->student, upload->student_folder};
    int result = score_without_trial(exercise, &submitter, verdict, why, &outcome, err);
    if (result == 0)
        result = keep_outcome(classroom, upload, &outcome, err);
    outcome_release(&outcome);
    return result;
}

/* What the upload refused: the student's mistake, or what the machine did not let us read. */
static int keep_refusal(struct classroom *classroom, const struct exercise *exercise,
                        const struct upload *upload, struct error *err)
{
    const enum verdict verdict = upload->refusal.is_fault ? VERDICT_FAULT : VERDICT_COMPILE_ERROR;
    return keep_without_trial(classroom, exercise, upload, verdict, &upload->refusal, err);
}

static int keep_fault(struct classroom *classroom, const struct exercise *exercise,
                      const struct upload *upload, const struct error *fault, struct error *err)
{
    static const struct cause harness = {"harness", {"grader", "corrector"}};
    struct refusal why = {0};
    refuse(&why, &harness, "The grader failed, not the submission, which gets no score: %s",
           "Falló el corrector, no la entrega, que queda sin puntuar: %s", fault->text);
    return keep_without_trial(classroom, exercise, upload, VERDICT_FAULT, &why, err);
}

/* Whether the store has a result of just these files that is no fault. */
static int is_graded(struct classroom *classroom, const struct upload *upload, bool *graded,
                     struct error *err)
{
    char digest[STORE_DIGEST];
    json_t *stored;
    *graded = false;
    if (classroom->regrade)
        return 0;
    digest_of(upload, digest);
    if (store_find(classroom->store, upload->student_folder,
                   upload->exercise ? upload->exercise : "unknown", digest, &stored, err) != 0)
        return -1;
    const char *verdict = json_string_value(json_object_get(stored, "verdict"));
    *graded = verdict && strcmp(verdict, verdict_name(VERDICT_FAULT)) != 0;
    json_decref(stored);
    return 0;
}

/* ----------------------------------------------------------------- lessons */

/* One exercise of the class: its yardstick, and the uploads that are to be graded, as a queue. */
struct lesson {
    const struct exercise *exercise;
    struct yardstick yardstick;
    bool made; /* the yardstick is there: a job may start */
    int *uploads;
    int count, next, running;
};

static int fill_queue(struct classroom *classroom, struct lesson *lesson, struct error *err)
{
    const struct upload_list *list = classroom->uploads;
    lesson->uploads = calloc((size_t)list->count + 1, sizeof *lesson->uploads);
    if (!lesson->uploads)
        return error_set(err, "out of memory");
    for (int i = 0; i < list->count; i++) {
        const struct upload *upload = &list->uploads[i];
        bool graded;
        if (!upload->exercise || strcmp(upload->exercise, lesson->exercise->name) != 0)
            continue;
        if (is_graded(classroom, upload, &graded, err) != 0)
            return -1;
        if (graded)
            classroom->done++;
        else if (!upload->refusal.refused)
            lesson->uploads[lesson->count++] = i;
        else if (keep_refusal(classroom, lesson->exercise, upload, err) != 0)
            return -1;
    }
    return 0;
}

static void close_lesson(struct lesson *lesson)
{
    if (lesson->made)
        yardstick_release(&lesson->yardstick);
    lesson->made = false;
}

/* Makes the yardstick; what fails for a moment is tried again. Returns -1 and why when it does not
 * help. */
static int open_lesson(struct lesson *lesson, uint32_t seed, struct error *why)
{
    for (int try = 0; try < TRIES; try++) {
        *why = (struct error){""};
        lesson->made = true; /* what was made in part is released, too */
        if (yardstick_make(&lesson->yardstick, lesson->exercise, seeds_of_class(seed), false,
                           why) == 0 &&
            yardstick_make_cases(&lesson->yardstick, false, why) == 0)
            return 0;
        close_lesson(lesson);
    }
    return -1;
}

/* Without a yardstick nobody's answer to this exercise can be judged: a fault each. The other
 * exercises are graded all the same. */
static int give_up_lesson(struct classroom *classroom, struct lesson *lesson,
                          const struct error *why, struct error *err)
{
    for (; lesson->next < lesson->count; lesson->next++) {
        const struct upload *upload = &classroom->uploads->uploads[lesson->uploads[lesson->next]];
        if (keep_fault(classroom, lesson->exercise, upload, why, err) != 0)
            return -1;
    }
    return 0;
}

/* -------------------------------------------------------------------- plan */

/* The lessons in their order, and the jobs at work. The last submissions of a lesson run on while
 * the next one's yardstick is made: a slow one keeps one core busy, not the class waiting. */
struct plan {
    struct lesson *lessons;
    int lesson_count, open; /* the lesson whose queue is being worked off */
    struct job jobs[JOBS_MAX];
    int running;
};

static int start_next(struct classroom *classroom, struct plan *plan, struct job *job,
                      struct error *err)
{
    struct lesson *lesson = &plan->lessons[plan->open];
    struct error why;
    if (!lesson->made && open_lesson(lesson, classroom->seed, &why) != 0)
        return give_up_lesson(classroom, lesson, &why, err);
    *job = (struct job){.lesson = plan->open, .upload = lesson->uploads[lesson->next++]};
    lesson->running++;
    plan->running++;
    return start_job(classroom, job, &lesson->yardstick, err);
}

/* Goes on to the next lesson with something to do; false when there is none. */
static bool has_next(struct plan *plan)
{
    while (plan->open < plan->lesson_count &&
           plan->lessons[plan->open].next == plan->lessons[plan->open].count)
        plan->open++;
    return plan->open < plan->lesson_count;
}

/* Gives every free job something to do, as long as there is anything. */
static int start_jobs(struct classroom *classroom, struct plan *plan, struct error *err)
{
    for (int i = 0; i < classroom->job_count; i++)
        while (!plan->jobs[i].pid && has_next(plan)) /* again: a lesson may have been given up */
            if (start_next(classroom, plan, &plan->jobs[i], err) != 0)
                return -1;
    return 0;
}

/* Deals with a job that ended: stores its outcome, or starts it a second time. */
static int settle(struct classroom *classroom, struct plan *plan, struct job *job,
                  struct error *err)
{
    struct lesson *lesson = &plan->lessons[job->lesson];
    const struct upload *upload = &classroom->uploads->uploads[job->upload];
    struct outcome outcome;
    struct error fault;
    int result = 0;
    finish_job(job, &outcome, &fault);
    bool again = !outcome.result && ++job->try < TRIES;
    if (again)
        result = start_job(classroom, job, &lesson->yardstick, err);
    else if (outcome.result)
        result = keep_outcome(classroom, upload, &outcome, err);
    else
        result = keep_fault(classroom, lesson->exercise, upload, &fault, err);
    outcome_release(&outcome);
    if (again)
        return result;
    plan->running--;
    if (--lesson->running == 0 && lesson->next == lesson->count)
        close_lesson(lesson);
    return result;
}

/* Waits until a job ends, and settles all that ended. */
static int settle_some(struct classroom *classroom, struct plan *plan, struct error *err)
{
    struct pollfd ends[JOBS_MAX];
    for (int i = 0; i < classroom->job_count; i++)
        ends[i] =
            (struct pollfd){.fd = plan->jobs[i].pid ? plan->jobs[i].pidfd : -1, .events = POLLIN};
    while (poll(ends, (nfds_t)classroom->job_count, -1) < 0 && errno == EINTR)
        continue;
    for (int i = 0; i < classroom->job_count; i++)
        if (plan->jobs[i].pid && (ends[i].revents & POLLIN) &&
            settle(classroom, plan, &plan->jobs[i], err) != 0)
            return -1;
    return 0;
}

static void abandon_jobs(struct job *jobs, int count)
{
    for (int i = 0; i < count; i++) {
        struct outcome outcome;
        struct error fault;
        if (!jobs[i].pid)
            continue;
        kill(jobs[i].pid, SIGKILL);
        finish_job(&jobs[i], &outcome, &fault);
        outcome_release(&outcome);
    }
}

static int run_plan(struct classroom *classroom, struct plan *plan, struct error *err)
{
    int result = start_jobs(classroom, plan, err);
    while (result == 0 && plan->running > 0) {
        result = settle_some(classroom, plan, err);
        if (result == 0)
            result = start_jobs(classroom, plan, err);
    }
    abandon_jobs(plan->jobs, classroom->job_count);
    return result;
}

/* Marks that rest on two measures are not made in silence. */
static int check_tools(struct classroom *classroom, const struct plan *plan, struct error *err)
{
    char difference[STORE_DIFFERENCE];
    int to_grade = 0;
    for (int i = 0; i < plan->lesson_count; i++)
        to_grade += plan->lessons[i].count;
    if (to_grade == 0 || classroom->mixes)
        return 0;
    int others = store_compare_tools(classroom->store, toolset_here(), difference, err);
    if (others <= 0)
        return others;
    return error_set(err,
                     "%d result%s in this folder %s made with other tools (%s): grade all of them "
                     "again (--rejudge --apply), take another folder, or go on with --mixed, which "
                     "the class page tells",
                     others, plural_ending(others), others == 1 ? "was" : "were", difference);
}

static int grade_lessons(struct classroom *classroom, struct error *err)
{
    struct plan plan = {.lesson_count = classroom->exercise_count};
    int result = 0;
    plan.lessons = calloc((size_t)plan.lesson_count + 1, sizeof *plan.lessons);
    if (!plan.lessons)
        return error_set(err, "out of memory");
    for (int i = 0; i < plan.lesson_count && result == 0; i++) {
        plan.lessons[i].exercise = &classroom->exercises[i];
        result = fill_queue(classroom, &plan.lessons[i], err);
    }
    if (result == 0)
        result = check_tools(classroom, &plan, err);
    if (result == 0)
        result = run_plan(classroom, &plan, err);
    for (int i = 0; i < plan.lesson_count; i++) {
        close_lesson(&plan.lessons[i]);
        free(plan.lessons[i].uploads);
    }
    free(plan.lessons);
    return result;
}

/* Submissions of which not even the exercise could be told. */
static int keep_unknown(struct classroom *classroom, struct error *err)
{
    for (int i = 0; i < classroom->uploads->count; i++) {
        const struct upload *upload = &classroom->uploads->uploads[i];
        if (!upload->exercise && keep_refusal(classroom, NULL, upload, err) != 0)
            return -1;
    }
    return 0;
}

static int prune(struct classroom *classroom, struct error *err)
{
    json_auto_t *keep = json_object();
    for (int i = 0; i < classroom->uploads->count; i++) {
        char key[PATH_MAX];
        const struct upload *upload = &classroom->uploads->uploads[i];
        snprintf(key, sizeof key, "%s/%s", upload->student_folder,
                 upload->exercise ? upload->exercise : "unknown");
        json_object_set_new(keep, key, json_true());
    }
    return store_prune(classroom->store, keep, err);
}

int classroom_grade(struct classroom *classroom, struct error *err)
{
    if (classroom->job_count < 1)
        classroom->job_count = 1;
    if (classroom->job_count > JOBS_MAX)
        classroom->job_count = JOBS_MAX;
    classroom->done = 0;
    classroom->total = classroom->uploads->count;
    if (!classroom->keep_others && prune(classroom, err) != 0)
        return -1;
    if (keep_unknown(classroom, err) != 0)
        return -1;
    return grade_lessons(classroom, err);
}
