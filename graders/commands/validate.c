/* meshgrade validate: the grader grades itself. Every submission below tests/submissions must get
 * its verdict and lose points for exactly what it is expected to, and every right one must keep a
 * margin to the bands. */
#include "graders/commands/common.h"
#include "graders/commands/expectation.h"
#include "graders/commands/options.h"
#include "graders/engine/base/files.h"
#include "graders/engine/classroom.h"
#include "reference/base/listing.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double MARGIN = 1.25; /* right answers stay this factor inside every band */

struct tally {
    int met, missed;
    bool verbose;
};

/* ----------------------------------------------------------------- loading */

static char *last_parts(const char *path, char *text, size_t capacity)
{
    const char *slash = strrchr(path, '/');
    while (slash && slash > path && slash[-1] != '/')
        slash--;
    snprintf(text, capacity, "%s", slash ? slash : path);
    return text;
}

/* "right/hash.c" becomes the student, "right-hash" the folder. */
static int load_submission(const char *path, const char *exercise, struct upload *upload,
                           struct error *err)
{
    char name[NAME_MAX * 2];
    const char *paths[] = {path};
    if (upload_read_files(paths, 1, exercise, upload, err) != 0)
        return -1;
    last_parts(path, name, sizeof name);
    free(upload->student);
    free(upload->student_folder);
    upload->student = strdup(name);
    name[strlen(name) - 2] = '\0';
    for (char *at = name; *at; at++)
        if (*at == '/')
            *at = '-';
    upload->student_folder = strdup(name);
    return upload->student && upload->student_folder ? 0 : error_set(err, "out of memory");
}

/* Paths of submissions. */
struct found {
    char **paths;
    int count;
};

static int add_path(struct found *found, const char *folder, const char *name, struct error *err)
{
    char **larger = realloc(found->paths, (size_t)(found->count + 1) * sizeof *larger);
    if (larger)
        found->paths = larger;
    if (!larger || asprintf(&larger[found->count], "%s/%s", folder, name) < 0) {
        error_set(err, "out of memory");
        return -1;
    }
    found->count++;
    return 0;
}

static int find_kind(const char *folder, struct found *found, struct error *err)
{
    char **names = listing_files(folder, ".c", err);
    int result = names ? 0 : -1;
    for (size_t i = 0; result == 0 && names[i]; i++)
        result = add_path(found, folder, names[i], err);
    free(names);
    return result;
}

static int find_submissions(const struct exercise *exercise, struct found *found, struct error *err)
{
    char folder[PATH_MAX], kind[PATH_MAX];
    const char *root = project_root(err);
    if (!root || file_path(folder, err, "%s/tests/submissions/%s/%s", root, exercise->group,
                           exercise->name) != 0)
        return -1;
    char **kinds = listing_folders(folder, err);
    int result = kinds ? 0 : -1;
    for (size_t i = 0; result == 0 && kinds[i]; i++) {
        result = file_path(kind, err, "%s/%s", folder, kinds[i]);
        if (result == 0)
            result = find_kind(kind, found, err);
    }
    free(kinds);
    if (result == 0 && !found->paths) {
        error_set(err, "%s: no submission to validate %s with (KIND/NAME.c)", folder,
                  exercise->name);
        return -1;
    }
    return result;
}

static void found_release(struct found *found)
{
    for (int i = 0; i < found->count; i++)
        free(found->paths[i]);
    free(found->paths);
}

static int load_submissions(const struct exercise *exercise, struct upload_list *list,
                            struct found *found, struct error *err)
{
    if (find_submissions(exercise, found, err) != 0)
        return -1;
    list->uploads = calloc((size_t)found->count + 1, sizeof *list->uploads);
    if (!list->uploads) {
        error_set(err, "out of memory");
        return -1;
    }
    for (int i = 0; i < found->count; i++) {
        if (load_submission(found->paths[i], exercise->name, &list->uploads[i], err) != 0)
            return -1;
        list->count++;
    }
    return 0;
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
                   const struct upload_list *list, const struct found *found, struct tally *tally,
                   struct error *err)
{
    for (int i = 0; i < list->count; i++) {
        struct expectation expected;
        char why[1200] = "";
        json_t *result;
        const struct upload *upload = &list->uploads[i];
        if (expectation_read(found->paths[i], &expected, err) != 0 ||
            store_find(store, upload->student_folder, exercise->name, NULL, &result, err) != 0)
            return -1;
        bool met = result && is_met(&expected, result, why, sizeof why);
        tally->met += met;
        tally->missed += !met;
        if (!met)
            printf("not as expected: %s %s %s\n", exercise->name, upload->student, why);
        else if (tally->verbose)
            printf("as expected: %s %s is %s, %.4g points\n", exercise->name, upload->student,
                   expected.verdict, json_number_value(json_object_get(result, "score")));
        json_decref(result);
    }
    return 0;
}

static int validate(const struct exercise *exercise, uint32_t seed, long jobs, struct tally *tally,
                    struct error *err)
{
    struct upload_list list = {0};
    struct store store = {NULL};
    struct found found = {0};
    char folder[PATH_MAX] = "";
    int result = load_submissions(exercise, &list, &found, err);
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
        result = compare(exercise, &store, &list, &found, tally, err);
    store_close(&store);
    folder_remove_work(folder);
    upload_list_release(&list);
    found_release(&found);
    return result;
}

static int run(int argc, char **argv)
{
    const char *jobs_text = NULL, *seed_text = NULL;
    uint32_t seed;
    struct tally tally = {0};
    const struct option_rule rules[] = {
        {"jobs", 'j', "N", "submissions at a time (default: one a core)", &jobs_text, NULL},
        {"seed", 0, "N", "as a class of this seed is graded (default: the published seeds)",
         &seed_text, NULL},
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
                result = validate(&exercises[i], seed, jobs, &tally, &err);
        printf("%d submissions as expected, %d not\n", tally.met, tally.missed);
        code = result != 0 ? report_fault(&err) : tally.missed ? EXIT_NOT_PASSED : EXIT_PASSED;
    }
    free(exercises);
    return code;
}

const struct command command_validate = {"validate", "[EXERCISE]",
                                         "every known-verdict submission gets its verdict", run};
