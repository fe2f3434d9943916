/* meshgrade grade: a class. */
#include "graders/commands/common.h"
#include "graders/commands/nearest.h"
#include "graders/commands/options.h"
#include "graders/commands/publish.h"
#include "graders/engine/base/files.h"
#include "graders/engine/classroom.h"
#include "graders/engine/result/lock.h"
#include "graders/engine/upload/names.h"
#include "reference/base/plural.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

struct request {
    const char *out, *jobs, *exercise, *only, *without, *seed_text;
    uint32_t seed; /* SEED_PUBLISHED: none asked for */
    bool regrade, apply, mixed, no_pictures, json;
};

/* ---------------------------------------------------------------- progress */

/* A fault is for who grades, at once and not only in the pages; the same one is told once. */
static void tell_fault(const json_t *result)
{
    static char told[MESSAGE_BYTES];
    const json_t *message = json_object_get(json_object_get(result, "summary"), "en");
    const char *text = json_string_value(message);
    const char *verdict = json_string_value(json_object_get(result, "verdict"));
    if (!text || !verdict || strcmp(verdict, "fault") != 0 || strcmp(told, text) == 0)
        return;
    snprintf(told, sizeof told, "%s", text);
    fprintf(stderr, "%smeshgrade: %s/%s: %s\n", isatty(STDERR_FILENO) ? "\r\033[K" : "",
            json_string_value(json_object_get(result, "student_folder")),
            json_string_value(json_object_get(result, "exercise")), text);
}

static void show_progress(const struct classroom *classroom, const json_t *result, int done,
                          int total)
{
    (void)classroom;
    tell_fault(result);
    if (!isatty(STDERR_FILENO))
        return;
    enum { WIDTH = 30 };
    int filled = total ? done * WIDTH / total : WIDTH;
    fprintf(stderr, "\r\033[K[%.*s%.*s] %d/%d  %.40s %.24s", filled,
            "##############################", WIDTH - filled, "..............................",
            done, total, json_string_value(json_object_get(result, "student_folder")),
            json_string_value(json_object_get(result, "exercise")));
    if (done == total)
        fprintf(stderr, "\r\033[K");
}

/* ----------------------------------------------------------------- uploads */

/* Says that nobody has that name, and whose is like it. */
static void complain_of_student(const struct upload_list *list, const char *student)
{
    char near[3 * NAMES_SLUG + 8] = "", slug[NAMES_SLUG];
    const char **folders = calloc((size_t)list->count + 1, sizeof *folders);
    int students = 0;
    for (int i = 0; folders && i < list->count; i++)
        if (i == 0 || strcmp(list->uploads[i].student_folder, folders[students - 1]) != 0)
            folders[students++] = list->uploads[i].student_folder;
    names_slug(slug, student);
    if (folders)
        nearest_names(slug, folders, (size_t)students, near, sizeof near);
    fprintf(stderr, "meshgrade: --only \"%s\": ", student);
    if (near[0])
        fprintf(stderr, "there is no such student; nearest: %s\n", near);
    else
        fprintf(stderr, "there is no such student among the %d student%s of these paths\n",
                students, plural_ending(students));
    free(folders);
}

static bool is_of(const struct upload *upload, const char *student)
{
    return strcmp(upload->student, student) == 0 || strcmp(upload->student_folder, student) == 0;
}

/* Keeps the uploads of one student, for --only. Returns -1 after saying that there are none. */
static int keep_only(struct upload_list *list, const char *student)
{
    int kept = 0;
    for (int i = 0; i < list->count; i++)
        kept += is_of(&list->uploads[i], student);
    if (kept == 0) {
        complain_of_student(list, student);
        return -1;
    }
    kept = 0;
    for (int i = 0; i < list->count; i++) {
        if (is_of(&list->uploads[i], student))
            list->uploads[kept++] = list->uploads[i];
        else
            upload_release(&list->uploads[i]);
    }
    list->count = kept;
    return 0;
}

static void print_changes(const struct classroom *classroom)
{
    size_t index;
    json_t *change;
    json_array_foreach(classroom->changes, index, change)
    {
        const json_t *before = json_object_get(change, "before");
        const json_t *after = json_object_get(change, "after");
        const char *was = json_string_value(json_object_get(before, "verdict"));
        fprintf(stderr, "  %-24s %-24s %s %.4g -> %s %.4g\n",
                json_string_value(json_object_get(after, "student_folder")),
                json_string_value(json_object_get(change, "exercise")), was ? was : "nothing",
                json_number_value(json_object_get(before, "score")),
                json_string_value(json_object_get(after, "verdict")),
                json_number_value(json_object_get(after, "score")));
    }
    fprintf(stderr, "%zu results differ; %s\n", json_array_size(classroom->changes),
            classroom->apply ? "applied" : "nothing was changed (--apply stores them)");
}

/* ------------------------------------------------------------------- grade */

/* Scratch folders stand below OUT, so that what a killed run leaves is removed by the next. */
static int use_scratch(const char *out, struct error *err)
{
    char path[PATH_MAX], absolute[PATH_MAX];
    if (file_path(path, err, "%s/scratch", out) != 0)
        return -1;
    folder_remove(path);
    if (folder_make(path, err) != 0)
        return -1;
    if (!realpath(path, absolute))
        return error_set(err, "%s: cannot be resolved", path);
    chmod(absolute, 0755);
    setenv("TMPDIR", absolute, 1);
    return 0;
}

static int grade(struct classroom *classroom, const struct request *request, struct error *err)
{
    struct store store;
    char scratch[PATH_MAX];
    int result = store_open(&store, request->out, err);
    classroom->store = &store;
    classroom->changes = json_array();
    if (result == 0)
        result = store_seed(&store, request->seed, &classroom->seed, err);
    if (result == 0)
        result = use_scratch(request->out, err);
    if (result == 0)
        result = classroom_grade(classroom, err);
    if (result == 0)
        result = store_write_files(&store, request->out, err);
    if (file_path(scratch, err, "%s/scratch", request->out) == 0)
        folder_remove(scratch);
    if (result == 0 && classroom->regrade)
        print_changes(classroom);
    json_decref(classroom->changes);
    classroom->changes = NULL;
    classroom->store = NULL;
    store_close(&store);
    return result;
}

/* Grades and publishes while no other run does so there. */
static int grade_alone(struct classroom *classroom, const struct request *request,
                       struct error *err)
{
    struct lock lock = {-1};
    int code = EXIT_FAULT;
    if (folder_make(request->out, err) == 0 && lock_take(&lock, request->out, err) == 0 &&
        grade(classroom, request, err) == 0)
        code = publish(request->out, !request->no_pictures, request->json, err);
    lock_release(&lock);
    return code;
}

/* Whether no two results could end up beside each other that other tools made: nothing is stored, or
 * everything anew. */
static bool is_of_one_measure(const struct request *request)
{
    bool of_all = !request->exercise && !request->only;
    return request->regrade && (!request->apply || of_all);
}

static int grade_uploads(const struct exercise *exercises, int count, struct upload_list *uploads,
                         long jobs, const struct request *request, struct error *err)
{
    struct classroom classroom = {.exercises = exercises,
                                  .exercise_count = count,
                                  .uploads = uploads,
                                  .job_count = (int)jobs,
                                  .regrade = request->regrade,
                                  .apply = request->apply,
                                  .keep_others =
                                      request->exercise || request->only || request->regrade,
                                  .mixes = request->mixed || is_of_one_measure(request),
                                  .progress = show_progress};
    if (request->only && keep_only(uploads, request->only) != 0)
        return EXIT_USAGE;
    for (int i = 0; i < uploads->note_count; i++)
        fprintf(stderr, "meshgrade: %s\n", uploads->notes[i]);
    return grade_alone(&classroom, request, err);
}

static int grade_paths(const struct exercise *exercises, int count, char **paths, int path_count,
                       const struct request *request)
{
    struct upload_list uploads = {0};
    struct error err = {""};
    /* One more than cores: some submissions only wait. Nothing that is marked rests on the clock.
     */
    long jobs = options_number("jobs", request->jobs, 1, sysconf(_SC_NPROCESSORS_ONLN) + 1);
    const char **names = exercise_names(exercises, count);
    int code = EXIT_FAULT;
    if (jobs < 1)
        code = EXIT_USAGE;
    else if (!names)
        error_set(&err, "out of memory");
    else if (upload_read((const char *const *)paths, path_count, names, request->exercise, &uploads,
                         &err) == 0)
        code = grade_uploads(exercises, count, &uploads, jobs, request, &err);
    if (code == EXIT_FAULT && err.text[0])
        code = report_fault(&err);
    upload_list_release(&uploads);
    free(names);
    return code;
}

static int run(int argc, char **argv)
{
    struct request request = {0};
    const struct option_rule rules[] = {
        {"out", 'o', "FOLDER", "where results, pages and pictures go (needed)", &request.out, NULL},
        {"jobs", 'j', "N", "submissions at a time (default: cores + 1)", &request.jobs, NULL},
        {"exercise", 'e', "NAME", "everything given is for this exercise", &request.exercise, NULL},
        {"only", 0, "STUDENT", "only this student", &request.only, NULL},
        {"rejudge", 0, NULL, "grade again what is graded, and show what would change", NULL,
         &request.regrade},
        {"apply", 0, NULL, "with --rejudge: store the changes", NULL, &request.apply},
        {"mixed", 0, NULL,
         "go on where results were made with other tools (another compiler, libc, "
         "valgrind, or other layers)",
         NULL, &request.mixed},
        {"seed", 0, "N", "seed of what is not public (default: FOLDER's, a new one is drawn)",
         &request.seed_text, NULL},
        {"no-pictures", 0, NULL, "leave the pictures for meshgrade report", NULL,
         &request.no_pictures},
        {"without", 0, "LAYERS", "leave protections out, to test the others (see doctor)",
         &request.without, NULL},
        {"json", 0, NULL, "the results as JSON instead of the table", NULL, &request.json},
        {0}};
    struct exercise *exercises = NULL;
    int count, code = EXIT_USAGE;
    int at = options_parse(&command_grade, rules, argc, argv);
    if (at < 0 || at >= argc || !request.out) {
        fprintf(stderr, "usage: meshgrade grade [options] PATH... -o FOLDER\n");
        return EXIT_USAGE;
    }
    if (request.apply && !request.regrade) {
        fprintf(stderr, "meshgrade: --apply goes with --rejudge\n");
        return EXIT_USAGE;
    }
    if (use_layers(request.without) != 0 ||
        options_seed(request.seed_text, SEED_PUBLISHED, &request.seed) != 0)
        return EXIT_USAGE;
    if (load_exercises(&exercises, &count) != 0)
        return EXIT_FAULT;
    if (!request.exercise || need_exercise(exercises, count, request.exercise))
        code = grade_paths(exercises, count, argv + at, argc - at, &request);
    free(exercises);
    return code;
}

const struct command command_grade = {
    "grade", "PATH... -o FOLDER", "grade a class: folders or archives; goes on where it stopped",
    run};
