/* Has every scene drawn that lacks an up-to-date picture; see report.h.
 *
 * One job, that is one process of meshgrade-render, a student: start-up costs half a second, and a
 * crash or a hang costs the pictures of one student only. Charts are made into scenes first; the
 * contact sheet of the class comes last, from one picture for each frequent cause. */
#include "graders/report/report.h"

#include "graders/report/causes.h"
#include "graders/report/chart.h"
#include "graders/report/documents.h"
#include "graders/report/renderer.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
    PICTURE_WIDTH = 720,
    PICTURE_HEIGHT = 540,
    CHART_WIDTH = 640,
    CHART_HEIGHT = 480,
    SHEET_CELLS = 24,
    SHEET_COLUMNS = 3,
    USELESS_LIMIT = 2,
    WORKERS_MAX = 16
};

struct drawing {
    const char *out;
    const char *renderer;
    int drawn;
    size_t undrawn;
    struct phrase reason; /* why; set with the first that was not drawn */
    int useless_in_a_row;
};

/* Whether `made` is there and not older than `from`. */
static bool is_up_to_date(const char *made, const char *from)
{
    struct stat a;
    struct stat b;
    if (stat(made, &a) != 0 || stat(from, &b) != 0 || a.st_size == 0)
        return false;
    return a.st_mtim.tv_sec != b.st_mtim.tv_sec ? a.st_mtim.tv_sec > b.st_mtim.tv_sec
                                                : a.st_mtim.tv_nsec >= b.st_mtim.tv_nsec;
}

/* ---------------------------------------------------------------- scenes of charts */

/* What the scene "<case>.json" shows when it is one of the charts written here; else no text. */
static struct phrase chart_noun(const char *file)
{
    if (strcmp(file, "growth.json") == 0)
        return (struct phrase){"growth", "crecimiento"};
    if (strcmp(file, "memory.json") == 0)
        return (struct phrase){"memory", "memoria"};
    return (struct phrase){NULL, NULL};
}

static bool is_chart(const char *file)
{
    return chart_noun(file).en != NULL;
}

static int write_chart(const char *out, const json_t *result, const char *name, json_t *scene,
                       struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    if (!scene)
        return 0;
    int status =
        document_path(path, err, "%s/pictures/%s/%s", out, result_text(result, "student_folder"),
                      result_text(result, "exercise"));
    if (status == 0)
        status = document_make_folders(path, err);
    if (status == 0)
        status = document_path(path, err, "%s/pictures/%s/%s/%s.json", out,
                               result_text(result, "student_folder"),
                               result_text(result, "exercise"), name);
    if (status == 0)
        status = document_write_json(path, scene, err);
    json_decref(scene);
    return status;
}

static int write_charts(const char *out, const struct gradebook *book, struct error *err)
{
    size_t i;
    json_t *result;
    json_array_foreach(book->all, i, result)
    {
        if (write_chart(out, result, "growth", chart_of_growth(result), err) != 0 ||
            write_chart(out, result, "memory", chart_of_memory(result), err) != 0)
            return -1;
    }
    return 0;
}

/* ---------------------------------------------------------------- jobs */

/* A job as JSON: pictures to draw, and the cells of the contact sheet. */
struct job {
    json_t *pictures;
    json_t *cells;
    size_t stale; /* pictures to draw */
};

static int job_start(struct job *job, struct error *err)
{
    *job = (struct job){.pictures = json_array(), .cells = json_array()};
    return job->pictures && job->cells ? 0 : error_set(err, "out of memory for a job");
}

static void job_release(struct job *job)
{
    json_decref(job->pictures);
    json_decref(job->cells);
}

static json_t *phrase_json(struct phrase phrase)
{
    return json_pack("{s:s, s:s}", "en", phrase.en, "es", phrase.es);
}

/* The pictures of a scene, "<stem>.png" and "<stem>.es.png", below OUT/pictures. */
static json_t *outs_of(const char *stem)
{
    char en[DOCUMENT_PATH_BYTES], es[DOCUMENT_PATH_BYTES];
    struct error ignored = {""};
    if (document_path(en, &ignored, "%s.png", stem) != 0 ||
        document_path(es, &ignored, "%s.es.png", stem) != 0)
        return NULL;
    return phrase_json((struct phrase){en, es});
}

static int job_add_cell(struct job *job, const char *stem, struct phrase caption, struct error *err)
{
    if (json_array_size(job->cells) >= SHEET_CELLS)
        return 0;
    if (json_array_append_new(job->cells, json_pack("{s:o, s:o}", "picture", outs_of(stem),
                                                    "caption", phrase_json(caption))) != 0)
        return error_set(err, "out of memory for a contact sheet");
    return 0;
}

/* Whether both pictures of a scene, a path without its ending, are there and fresh. */
static bool has_pictures(const char *out, const char *stem)
{
    static const char *const endings[] = {".png", ".es.png"};
    char scene[DOCUMENT_PATH_BYTES], picture[DOCUMENT_PATH_BYTES];
    struct error ignored = {""};
    if (document_path(scene, &ignored, "%s/pictures/%s.json", out, stem) != 0)
        return false;
    for (size_t i = 0; i < 2; i++)
        if (document_path(picture, &ignored, "%s/pictures/%s%s", out, stem, endings[i]) != 0 ||
            !is_up_to_date(picture, scene))
            return false;
    return true;
}

/* Adds one scene, "<student>/<exercise>/<case>" below OUT/pictures. */
static int job_add_scene(struct job *job, const char *out, const char *stem, struct phrase caption,
                         bool chart, struct error *err)
{
    char scene[DOCUMENT_PATH_BYTES];
    if (document_path(scene, err, "%s.json", stem) != 0)
        return -1;
    if (!has_pictures(out, stem)) {
        job->stale++;
        if (json_array_append_new(job->pictures,
                                  json_pack("{s:s, s:o, s:i, s:i}", "scene", scene, "out",
                                            outs_of(stem), "width",
                                            chart ? CHART_WIDTH : PICTURE_WIDTH, "height",
                                            chart ? CHART_HEIGHT : PICTURE_HEIGHT)) != 0)
            return error_set(err, "out of memory for a job");
    }
    return job_add_cell(job, stem, caption, err);
}

/* What of an exercise is added: the order on the sheet. */
enum part { FIRST_OF_CAUSE, OTHER_CASES, CHARTS, PART_COUNT };

/* The cause of a case whose scene is "<case>.json"; "" when there is no such case. */
static const char *cause_of_scene(const json_t *result, const char *scene)
{
    size_t i, length = strlen(scene) - strlen(".json");
    json_t *one;
    json_array_foreach(json_object_get(result, "cases"), i, one)
    {
        const char *name = result_text(one, "name");
        if (strlen(name) == length && strncmp(name, scene, length) == 0)
            return result_text(one, "cause");
    }
    return "";
}

static enum part part_of(const json_t *result, char *const *scenes, size_t index)
{
    if (is_chart(scenes[index]))
        return CHARTS;
    const char *cause = cause_of_scene(result, scenes[index]);
    for (size_t i = 0; i < index; i++)
        if (!is_chart(scenes[i]) && strcmp(cause_of_scene(result, scenes[i]), cause) == 0)
            return OTHER_CASES;
    return FIRST_OF_CAUSE;
}

/* Adds a part of the scenes of a student's exercise. */
static int job_add_folder(struct job *job, const char *out, const json_t *result, enum part part,
                          struct error *err)
{
    const char *student = result_text(result, "student_folder");
    const char *exercise = result_text(result, "exercise");
    char path[DOCUMENT_PATH_BYTES];
    if (document_path(path, err, "%s/pictures/%s/%s", out, student, exercise) != 0)
        return -1;
    char **scenes = document_list(path, ".json", err);
    int status = scenes ? 0 : -1;
    for (size_t i = 0; status == 0 && scenes[i]; i++) {
        struct message caption;
        size_t length = strlen(scenes[i]) - strlen(".json");
        if (part_of(result, scenes, i) != part)
            continue;
        message_say(&caption, "%s: ", "%s: ", exercise);
        if (part == CHARTS)
            message_add_phrase(&caption, chart_noun(scenes[i]));
        else
            message_add(&caption, "%.*s", "%.*s", (int)length, scenes[i]);
        status = document_path(path, err, "%s/%s/%.*s", student, exercise, (int)length, scenes[i]);
        if (status == 0)
            status = job_add_scene(job, out, path, message_phrase(&caption), part == CHARTS, err);
    }
    free(scenes);
    return status;
}

/* How many scenes of a job have fresh pictures now. */
static size_t count_fresh(const struct job *job, const char *out)
{
    size_t fresh = 0;
    size_t i;
    json_t *picture;
    json_array_foreach(job->pictures, i, picture)
    {
        const char *scene = result_text(picture, "scene");
        char stem[DOCUMENT_PATH_BYTES];
        snprintf(stem, sizeof stem, "%.*s", (int)(strlen(scene) - strlen(".json")), scene);
        fresh += has_pictures(out, stem);
    }
    return fresh;
}

static void note_undrawn(struct drawing *drawing, size_t count, struct phrase reason)
{
    if (count > 0 && !drawing->reason.en)
        drawing->reason = reason;
    drawing->undrawn += count;
}

/* Draws a job and its sheet (a path below OUT/pictures, without ending), when there is anything to
 * draw. */
static int draw(struct drawing *drawing, struct job *job, const char *sheet, struct phrase title,
                struct error *err)
{
    char sheet_path[DOCUMENT_PATH_BYTES];
    char path[DOCUMENT_PATH_BYTES];
    if (document_path(sheet_path, err, "%s/pictures/%s.png", drawing->out, sheet) != 0 ||
        document_path(path, err, "%s/pictures/job-%d.json", drawing->out, (int)getpid()) != 0)
        return -1;
    bool sheet_was_there = access(sheet_path, R_OK) == 0;
    if (json_array_size(job->cells) == 0 || (job->stale == 0 && sheet_was_there))
        return 0;
    if (!drawing->renderer) {
        note_undrawn(drawing, job->stale, drawing->reason);
        return 0;
    }
    json_t *json = json_pack("{s:O, s:[{s:o, s:s, s:o, s:i, s:O}]}", "pictures", job->pictures,
                             "sheets", "title", phrase_json(title), "subtitle", "", "out",
                             outs_of(sheet), "columns", SHEET_COLUMNS, "cells", job->cells);
    int status =
        json ? document_write_json(path, json, err) : error_set(err, "out of memory for a job");
    json_decref(json);
    if (status != 0)
        return -1;
    struct phrase reason = {NULL, NULL};
    enum renderer_end end =
        renderer_run(drawing->renderer, path, renderer_limits(job->stale), &reason);
    unlink(path);
    size_t fresh = count_fresh(job, drawing->out);
    bool sheet_is_new = access(sheet_path, R_OK) == 0 && (fresh > 0 || !sheet_was_there);
    drawing->drawn += (int)fresh + (sheet_is_new ? 1 : 0);
    note_undrawn(drawing, job->stale - fresh, reason.en ? reason : renderer_default_reason());
    drawing->useless_in_a_row = end == RENDERER_USELESS ? drawing->useless_in_a_row + 1 : 0;
    if (drawing->useless_in_a_row == USELESS_LIMIT)
        drawing->renderer = NULL; /* nor would it draw the others */
    return 0;
}

static int draw_student(struct drawing *drawing, const struct gradebook *book,
                        const struct student *student, struct error *err)
{
    struct job job;
    const char *name = json_string_value(student->name);
    char sheet[200];
    snprintf(sheet, sizeof sheet, "%s/sheet", student->folder);
    int status = job_start(&job, err);
    for (int part = 0; part < PART_COUNT; part++) /* each cause stands once at the beginning */
        for (size_t e = 0; status == 0 && e < book->exercise_count; e++)
            if (student->results[e])
                status =
                    job_add_folder(&job, drawing->out, student->results[e], (enum part)part, err);
    if (status == 0)
        status = draw(drawing, &job, sheet, (struct phrase){name, name}, err);
    job_release(&job);
    return status;
}

/* ---------------------------------------------------------------- workers */

/* What a worker hands back through its pipe. */
struct share {
    int status, drawn;
    size_t undrawn;
    struct message reason;
    struct error err;
};

/* Draws every worker_count-th student, in a child process. */
_Noreturn static void draw_share(struct drawing *drawing, const struct gradebook *book,
                                 size_t worker, size_t worker_count, int to)
{
    static struct share share;
    for (size_t s = worker; share.status == 0 && s < book->student_count; s += worker_count)
        share.status = draw_student(drawing, book, &book->students[s], &share.err);
    share.drawn = drawing->drawn;
    share.undrawn = drawing->undrawn;
    if (drawing->reason.en)
        message_set_phrase(&share.reason, drawing->reason);
    _exit(write(to, &share, sizeof share) == (ssize_t)sizeof share ? 0 : 1);
}

/* Adds what a worker has done; its reason is kept until the next call of this program's life. */
static int add_share(struct drawing *drawing, int from, struct error *err)
{
    static struct share share, told;
    if (read(from, &share, sizeof share) != (ssize_t)sizeof share)
        return error_set(err, "a worker that draws pictures vanished");
    if (share.status != 0)
        return error_set(err, "%s", share.err.text);
    drawing->drawn += share.drawn;
    if (share.reason.en[0] && !drawing->reason.en)
        told = share;
    note_undrawn(drawing, share.undrawn, message_phrase(&told.reason));
    return 0;
}

/* Draws the students in parallel, one worker a core: VTK allows one thread a process. */
static int draw_students(struct drawing *drawing, const struct gradebook *book, struct error *err)
{
    int from[WORKERS_MAX], ends[2], status = 0;
    pid_t workers[WORKERS_MAX];
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    size_t count = cores < 1 ? 1 : cores > WORKERS_MAX ? WORKERS_MAX : (size_t)cores, started = 0;
    fflush(NULL);
    for (; started < count && status == 0; started++) {
        if (pipe2(ends, O_CLOEXEC) != 0) {
            status = error_set(err, "cannot start a worker that draws pictures");
            break;
        }
        from[started] = ends[0];
        workers[started] = fork();
        if (workers[started] == 0)
            draw_share(drawing, book, started, count, ends[1]);
        close(ends[1]);
        if (workers[started] < 0)
            status = error_set(err, "cannot start a worker that draws pictures");
    }
    for (size_t i = 0; i < started; i++) {
        if (status == 0)
            status = add_share(drawing, from[i], err);
        close(from[i]);
        if (workers[i] > 0)
            waitpid(workers[i], NULL, 0);
    }
    return status;
}

/* The sheet of the class: for every exercise its most frequent causes, one picture each. */
static int add_causes(struct job *job, const char *out, const struct gradebook *book,
                      size_t exercise, struct error *err)
{
    struct causes causes;
    if (causes_of(book, exercise, &causes, err) != 0)
        return -1;
    int status = 0;
    for (size_t i = 0; status == 0 && i < causes.count; i++) {
        const struct class_cause *cause = &causes.list[i];
        char stem[DOCUMENT_PATH_BYTES];
        char picture[DOCUMENT_PATH_BYTES];
        char slug[64];
        struct message caption;
        if (!cause->case_name)
            continue;
        message_say(&caption, "%s: ", "%s: ", book->exercises[exercise].name);
        message_add_phrase(&caption, causes_name(cause, slug, sizeof slug));
        message_add(&caption, " (%zu of %zu)", " (%zu de %zu)", cause->student_count,
                    causes.answer_count);
        status =
            document_path(stem, err, "%s/%s/%s", result_text(cause->scene_result, "student_folder"),
                          book->exercises[exercise].name, cause->case_name);
        if (status == 0)
            status = document_path(picture, err, "%s/pictures/%s.png", out, stem);
        if (status == 0 && access(picture, R_OK) == 0)
            status = job_add_scene(job, out, stem, message_phrase(&caption), false, err);
    }
    causes_release(&causes);
    return status;
}

static int draw_class(struct drawing *drawing, const struct gradebook *book, struct error *err)
{
    struct job job;
    static const char *const sheets[] = {"class.png", "class.es.png"};
    char sheet[DOCUMENT_PATH_BYTES];
    int status = job_start(&job, err);
    for (size_t e = 0; status == 0 && e < book->exercise_count; e++)
        status = add_causes(&job, drawing->out, book, e, err);
    /* Captions change with every result, so it is made anew whenever anything was drawn. */
    for (size_t i = 0; status == 0 && drawing->drawn > 0 && i < 2; i++)
        if (document_path(sheet, err, "%s/pictures/%s", drawing->out, sheets[i]) == 0)
            unlink(sheet);
    if (status == 0)
        status =
            draw(drawing, &job, "class",
                 (struct phrase){"The most frequent causes", "Las causas más frecuentes"}, err);
    job_release(&job);
    return status;
}

/* ---------------------------------------------------------------- the whole */

static int write_status(const struct drawing *drawing, struct error *err)
{
    char path[DOCUMENT_PATH_BYTES];
    bool told = drawing->undrawn > 0;
    json_t *status =
        json_pack("{s:I, s:{s:s, s:s}}", "undrawn", (json_int_t)drawing->undrawn, "reason", "en",
                  told ? drawing->reason.en : "", "es", told ? drawing->reason.es : "");
    int result = status ? 0 : error_set(err, "out of memory for the status of pictures");
    if (result == 0)
        result = document_path(path, err, "%s/pictures/status.json", drawing->out);
    if (result == 0)
        result = document_write_json(path, status, err);
    json_decref(status);
    return result;
}

int report_pictures(const char *out, const char *renderer_path, struct error *err)
{
    struct gradebook book;
    char pictures[DOCUMENT_PATH_BYTES];
    if (document_path(pictures, err, "%s/pictures", out) != 0 ||
        gradebook_load(out, &book, err) != 0)
        return -1;
    struct drawing drawing = {.out = out, .renderer = renderer_path};
    if (!renderer_path || access(renderer_path, X_OK) != 0) {
        drawing.renderer = NULL;
        drawing.reason = renderer_absent_reason();
    }
    int status = document_make_folders(pictures, err);
    if (status == 0)
        status = write_charts(out, &book, err);
    if (status == 0)
        status = draw_students(&drawing, &book, err);
    if (status == 0)
        status = draw_class(&drawing, &book, err);
    if (status == 0)
        status = write_status(&drawing, err);
    gradebook_release(&book);
    return status == 0 ? drawing.drawn : -1;
}

void report_pictures_reason(const char *out, char *text, size_t capacity)
{
    char path[DOCUMENT_PATH_BYTES];
    struct error ignored = {""};
    json_t *status = NULL;
    if (document_path(path, &ignored, "%s/pictures/status.json", out) == 0)
        status = document_read_json(path, &ignored);
    snprintf(text, capacity, "%s", words_in(status, "reason").en);
    json_decref(status);
}
