/* meshgrade validate: the grader grades itself. Every submission below tests/submissions must get
 * its verdict and lose points for exactly what it is expected to, and every right one must keep a
 * margin to the bands. */
#include "graders/commands/common.h"
#include "graders/commands/options.h"
#include "graders/engine/base/files.h"
#include "graders/engine/classroom.h"
#include "graders/engine/upload/sources.h"
#include "graders/known/submissions.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double MARGIN = 1.25; /* right answers stay this factor inside every band */

struct tally {
    int met, missed;
    bool verbose;
};

/* ----------------------------------------------------------------- loading */

/* "right/hash.c" becomes the student, "right-hash" the folder. */
static int make_upload(const struct known_submission *known, const char *exercise,
                       struct upload *upload, struct error *err)
{
    const char *name = strchr(known->file, '/') + 1;
    upload->student = strdup(known->file);
    upload->student_folder = strndup(known->file, strlen(known->file) - strlen(".c"));
    upload->exercise = exercise;
    if (!upload->student || !upload->student_folder)
        return error_set(err, "out of memory");
    upload->student_folder[name - 1 - known->file] = '-';
    if (upload_take_source(upload, name, strlen(name), known->text, known->count, err) != 0)
        return -1;
    upload_settle(upload);
    return 0;
}

static int make_uploads(const struct exercise *exercise, const struct known_list *known,
                        struct upload_list *list, struct error *err)
{
    list->uploads = calloc((size_t)known->count + 1, sizeof *list->uploads);
    if (!list->uploads)
        return error_set(err, "out of memory");
    for (; list->count < known->count; list->count++)
        if (make_upload(&known->submissions[list->count], exercise->name,
                        &list->uploads[list->count], err) != 0)
            return -1;
    return 0;
}

static int read_known(const struct exercise *exercise, struct known_list *known, struct error *err)
{
    const char *root = project_root(err);
    if (!root || known_read(root, exercise->group, exercise->name, known, err) != 0)
        return -1;
    if (known->count == 0)
        return error_set(err, "%s/tests/submissions/%s/%s: no submission to validate %s with", root,
                         exercise->group, exercise->name, exercise->name);
    return 0;
}

/* Writes the whole files below <folder>/<group>/<exercise>/. */
static int expand(const struct exercise *exercise, const char *folder, struct error *err)
{
    struct known_list known = {0};
    char path[PATH_MAX];
    int result = read_known(exercise, &known, err);
    if (snprintf(path, sizeof path, "%s/%s/%s", folder, exercise->group, exercise->name) >=
        (int)sizeof path)
        result = error_set(err, "%s: the path is too long", folder);
    if (result == 0)
        result = known_write(&known, path, err);
    known_release(&known);
    return result;
}

/* ----------------------------------------------------------------- judging */

static bool has_margin(const json_t *result, char *why, size_t capacity)
{
    static const char *const bands[] = {"work", "memory"};
    for (int i = 0; i < 2; i++) {
        const json_t *band = json_object_get(json_object_get(result, "measures"), bands[i]);
        double ratio = json_number_value(json_object_get(band, "ratio"));
        double limit = json_number_value(json_object_get(band, "band"));
        if (!band || ratio * MARGIN <= limit)
            continue;
        snprintf(why, capacity, "%s is %.3g of at most %.3g: less than the margin of %.2f",
                 bands[i], ratio, limit, MARGIN);
        return false;
    }
    return true;
}

static bool is_met(const struct expectation *expected, const json_t *result, char *why,
                   size_t capacity)
{
    const char *verdict = json_string_value(json_object_get(result, "verdict"));
    if (strcmp(verdict, expected->verdict) != 0) {
        const json_t *summary = json_object_get(result, "summary");
        snprintf(why, capacity, "is %s (%s: %s), expected %s", verdict,
                 json_string_value(json_object_get(result, "cause")),
                 json_string_value(json_object_get(summary, "en")), expected->verdict);
        return false;
    }
    if (!expectation_failures_match(expected, result, why, capacity))
        return false;
    return strcmp(verdict, verdict_name(VERDICT_PASSED)) != 0 || has_margin(result, why, capacity);
}

static int compare(const struct exercise *exercise, struct store *store,
                   const struct upload_list *list, const struct known_list *known,
                   struct tally *tally, struct error *err)
{
    for (int i = 0; i < list->count; i++) {
        const struct expectation *expected = &known->submissions[i].expected;
        char why[1200] = "";
        json_t *result;
        const struct upload *upload = &list->uploads[i];
        if (store_find(store, upload->student_folder, exercise->name, NULL, &result, err) != 0)
            return -1;
        bool met = result && is_met(expected, result, why, sizeof why);
        tally->met += met;
        tally->missed += !met;
        if (!met)
            printf("not as expected: %s %s %s\n", exercise->name, upload->student, why);
        else if (tally->verbose)
            printf("as expected: %s %s is %s, %.4g points\n", exercise->name, upload->student,
                   expected->verdict, json_number_value(json_object_get(result, "score")));
        json_decref(result);
    }
    return 0;
}

static int validate(const struct exercise *exercise, uint32_t seed, long jobs, struct tally *tally,
                    struct error *err)
{
    struct known_list known = {0};
    struct upload_list list = {0};
    struct store store = {NULL};
    char folder[PATH_MAX] = "";
    int result = read_known(exercise, &known, err);
    if (result == 0)
        result = make_uploads(exercise, &known, &list, err);
    if (result == 0)
        result = folder_make_work(folder, err);
    if (result == 0)
        result = store_open(&store, folder, err);
    struct classroom classroom = {.exercises = exercise,
                                  .exercise_count = 1,
                                  .uploads = &list,
                                  .store = &store,
                                  .seed = seed,
                                  .job_count = (int)jobs};
    if (result == 0)
        result = classroom_grade(&classroom, err);
    if (result == 0)
        result = compare(exercise, &store, &list, &known, tally, err);
    store_close(&store);
    folder_remove_work(folder);
    upload_list_release(&list);
    known_release(&known);
    return result;
}

static int run(int argc, char **argv)
{
    const char *jobs_text = NULL, *seed_text = NULL, *folder = NULL;
    uint32_t seed;
    struct tally tally = {0};
    const struct option_rule rules[] = {
        {"jobs", 'j', "N", "submissions at a time (default: one a core)", &jobs_text, NULL},
        {"seed", 0, "N", "as a class of this seed is graded (default: the published seeds)",
         &seed_text, NULL},
        {"expand", 0, "DIR", "only write the submissions to DIR, each as a whole file", &folder,
         NULL},
        {"verbose", 'v', NULL, "a line also for what is as expected", NULL, &tally.verbose},
        {0}};
    struct exercise *exercises = NULL;
    struct error err = {""};
    int count, code = EXIT_USAGE;
    int at = options_parse(&command_validate, rules, argc, argv);
    long jobs = options_number("jobs", jobs_text, 1, sysconf(_SC_NPROCESSORS_ONLN));
    if (at < 0 || jobs < 0 || options_seed(seed_text, SEED_PUBLISHED, &seed) != 0 ||
        load_exercises(&exercises, &count) != 0)
        return EXIT_USAGE;
    if (at >= argc || need_exercise(exercises, count, argv[at])) {
        int result = 0;
        for (int i = 0; i < count && result == 0; i++)
            if (at >= argc || strcmp(exercises[i].name, argv[at]) == 0)
                result = folder ? expand(&exercises[i], folder, &err)
                                : validate(&exercises[i], seed, jobs, &tally, &err);
        if (!folder)
            printf("%d submissions as expected, %d not\n", tally.met, tally.missed);
        code = result != 0 ? report_fault(&err) : tally.missed ? EXIT_NOT_PASSED : EXIT_PASSED;
    }
    free(exercises);
    return code;
}

const struct command command_validate = {"validate", "[EXERCISE]",
                                         "every known-verdict submission gets its verdict", run};
