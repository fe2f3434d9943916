/* meshgrade validate: the grader grades itself. Every submission below tests/submissions must get
 * its verdict and lose points for exactly what it is expected to, and every right one must keep a
 * margin to the bands. */
#include "graders/commands/common.h"
#include "graders/commands/options.h"
#include "graders/engine/base/files.h"
#include "graders/engine/build/compiler.h"
#include "graders/engine/classroom.h"
#include "graders/engine/upload/sources.h"
#include "graders/judges/table.h"
#include "graders/known/stamps.h"
#include "graders/known/submissions.h"
#include "graders/known/wording.h"
#include "reference/base/plural.h"

#include <limits.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { RIGHT_LEAST = 3 };

/* What is asked for, and what came of it. */
struct plan {
    const char *only, *folder;
    bool again, brief, verbose;
    uint32_t seed;
    long jobs;
    char machine[STAMP_KEY]; /* empty: nothing is remembered */
    int met, missed, as_before;
    int lacks; /* of the sets of submissions */
    bool is_usage_error;
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

/* Whether a file is called so: "wrong/a.c", "wrong/a", or as it is stored. */
static bool is_called(const struct known_submission *submission, const char *name, size_t length)
{
    size_t whole = strlen(submission->file), stored = strlen(submission->stored);
    return (length == whole && strncmp(submission->file, name, length) == 0) ||
           (length == whole - strlen(".c") && strncmp(submission->file, name, length) == 0) ||
           (length < stored && submission->stored[stored - length - 1] == '/' &&
            strncmp(submission->stored + stored - length, name, length) == 0 &&
            memchr(name, '/', length) != NULL);
}

/* Leaves those that --only names. */
static int keep_only(struct plan *plan, struct known_list *known, struct error *err)
{
    bool *kept = calloc((size_t)known->count + 1, sizeof *kept);
    if (!kept)
        return error_set(err, "out of memory");
    int result = 0;
    for (const char *name = plan->only; *name && result == 0;) {
        size_t length = strcspn(name, ",");
        bool found = false;
        for (int i = 0; i < known->count; i++) {
            bool is_this = is_called(&known->submissions[i], name, length);
            found |= is_this;
            kept[i] |= is_this;
        }
        if (!found) {
            plan->is_usage_error = true;
            result = error_set(err, "--only %.*s: no such submission; name it as wrong/FILE.c",
                               (int)length, name);
        }
        name += length + (name[length] == ',');
    }
    if (result == 0)
        known_keep(known, kept);
    free(kept);
    return result;
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

/* What became of a submission. */
struct finding {
    bool is_met, is_as_before, is_to_do;
    unsigned left_out;       /* steps that were not run; see trial_scope */
    char failed[STAMP_TEXT]; /* classes, when it is met */
};

/* An exercise being validated. */
struct subject {
    const struct exercise *exercise;
    struct known_list known;
    struct finding *findings; /* one a submission */
    struct stamps stamps;
    bool remembers; /* stamps are open */
};

static void open_stamps(const struct plan *plan, struct subject *subject)
{
    struct error err = {""};
    const char *root = project_root(&err);
    subject->remembers = root && plan->machine[0] &&
                         stamps_open(root, subject->exercise, plan->seed, plan->machine,
                                     &subject->stamps, &err) == 0;
    for (int i = 0; i < subject->known.count && subject->remembers; i++) {
        struct finding *finding = &subject->findings[i];
        finding->is_as_before =
            !plan->again &&
            stamps_hold(&subject->stamps, &subject->known.submissions[i], finding->failed);
        finding->is_met = finding->is_as_before;
    }
}

/* A full pass: nothing was left unmeasured. Stamps only when nothing that the verdict depends on
 * was edited while it was made. */
static int put_stamps(const struct plan *plan, const struct subject *subject, struct error *err)
{
    struct stamps now;
    struct error ignored = {""};
    const char *root = project_root(err);
    if (!subject->remembers ||
        stamps_open(root, subject->exercise, plan->seed, plan->machine, &now, &ignored) != 0 ||
        strcmp(now.circumstances, subject->stamps.circumstances) != 0)
        return 0;
    for (int i = 0; i < subject->known.count; i++) {
        const struct finding *finding = &subject->findings[i];
        if (finding->is_met && !finding->is_as_before && finding->left_out == 0 &&
            stamps_put(&now, &subject->known.submissions[i], finding->failed, err) != 0)
            return -1;
    }
    return 0;
}

static int compare(struct plan *plan, struct subject *subject, struct store *store,
                   const struct upload *upload, int index, bool *is_whole, struct error *err)
{
    const struct expectation *expected = &subject->known.submissions[index].expected;
    struct finding *finding = &subject->findings[index];
    const char *exercise = subject->exercise->name;
    char why[1200] = "no result";
    json_t *result;
    if (store_find(store, upload->student_folder, exercise, NULL, &result, err) != 0)
        return -1;
    finding->is_met = result && expectation_is_met(expected, result, why, sizeof why) &&
                      wording_is_sound(result, why, sizeof why);
    if (finding->left_out == 0)
        *is_whole &= json_array_size(json_object_get(result, "not_measured")) == 0;
    expectation_failed_classes(result, finding->failed, sizeof finding->failed);
    finding->is_to_do = !finding->is_met && finding->left_out != 0;
    if (finding->is_to_do) /* what was left out may decide it: nothing is left out the next time */
        finding->left_out = 0;
    else if (!finding->is_met && subject->remembers) /* with --again it may have one */
        stamps_remove(&subject->stamps, &subject->known.submissions[index]);
    if (!finding->is_met && !finding->is_to_do)
        printf("not as expected: %s %s %s\n", exercise, upload->student, why);
    if (finding->is_met && plan->verbose)
        printf("as expected: %s %s is %s, %.4g points\n", exercise, upload->student,
               expected->verdict, json_number_value(json_object_get(result, "score")));
    json_decref(result);
    return 0;
}

/* Makes the uploads of what is to be graded, and says of each what is left out. */
static int make_uploads(const struct subject *subject, struct upload_list *list,
                        unsigned **left_out, struct error *err)
{
    list->uploads = calloc((size_t)subject->known.count + 1, sizeof *list->uploads);
    *left_out = calloc((size_t)subject->known.count + 1, sizeof **left_out);
    if (!list->uploads || !*left_out)
        return error_set(err, "out of memory");
    for (int i = 0; i < subject->known.count; i++) {
        if (!subject->findings[i].is_to_do)
            continue;
        (*left_out)[list->count] = subject->findings[i].left_out;
        if (make_upload(&subject->known.submissions[i], subject->exercise->name,
                        &list->uploads[list->count++], err) != 0)
            return -1;
    }
    return 0;
}

/* Grades what is to be done. */
static int grade(struct plan *plan, struct subject *subject, struct error *err)
{
    struct upload_list list = {0};
    struct store store = {NULL};
    char folder[PATH_MAX] = "";
    bool is_whole = true;
    unsigned *left_out = NULL;
    int result = make_uploads(subject, &list, &left_out, err);
    if (result == 0)
        result = folder_make_work(folder, err);
    if (result == 0)
        result = store_open(&store, folder, err);
    struct classroom classroom = {.exercises = subject->exercise,
                                  .exercise_count = 1,
                                  .uploads = &list,
                                  .store = &store,
                                  .seed = plan->seed,
                                  .job_count = (int)plan->jobs,
                                  .left_out = left_out};
    if (result == 0)
        result = classroom_grade(&classroom, err);
    for (int i = 0, next = 0; i < subject->known.count && result == 0; i++)
        if (subject->findings[i].is_to_do)
            result = compare(plan, subject, &store, &list.uploads[next++], i, &is_whole, err);
    store_close(&store);
    folder_remove_work(folder);
    upload_list_release(&list);
    free(left_out);
    return result == 0 && is_whole ? put_stamps(plan, subject, err) : result;
}

static bool has_to_do(const struct subject *subject)
{
    for (int i = 0; i < subject->known.count; i++)
        if (subject->findings[i].is_to_do)
            return true;
    return false;
}

/* ------------------------------------------------------------------ the set */

static void miss(struct plan *plan, const struct exercise *exercise, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void miss(struct plan *plan, const struct exercise *exercise, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    printf("not as expected: tests/submissions/%s/%s: ", exercise->group, exercise->name);
    vprintf(format, arguments);
    putchar('\n');
    va_end(arguments);
    plan->lacks++;
}

static int count_kind(const struct subject *subject, const char *kind)
{
    int count = 0;
    for (int i = 0; i < subject->known.count; i++)
        count += known_is(&subject->known.submissions[i], kind);
    return count;
}

static bool fails_alone(const struct subject *subject, const char *class,
                        const struct quality_rule *rule)
{
    for (int i = 0; i < subject->known.count; i++)
        if (subject->findings[i].is_met &&
            expectation_fails_just(subject->findings[i].failed, class, rule))
            return true;
    return false;
}

/* Whether the submissions can tell a judge that works from one that does not. */
static void check_set(struct plan *plan, const struct subject *subject)
{
    static const struct quality_rule none;
    const struct exercise *exercise = subject->exercise;
    const struct judge *judge = judge_find(exercise->name);
    const struct quality_rule *rule = judge ? &judge->quality : &none;
    int right = count_kind(subject, "right");
    if (right < RIGHT_LEAST)
        miss(plan, exercise, "%d right answer%s; write %d by different methods in right/", right,
             plural_ending(right), RIGHT_LEAST);
    if (exercise->checked[CHECK_GROWTH] && count_kind(subject, "slow") == 0)
        miss(plan, exercise, "growth is judged and nothing is slow; write one in slow/");
    for (int i = 0; i < exercise->class_count; i++) {
        const char *class = exercise->classes[i].name;
        if (!fails_alone(subject, class, rule))
            miss(plan, exercise, "no submission fails just class %s; write one in %s/", class,
                 quality_band_of(rule, class) ? "poor" : "wrong");
    }
}

static int validate(struct plan *plan, const struct exercise *exercise, struct error *err)
{
    struct subject subject = {.exercise = exercise};
    int result = read_known(exercise, &subject.known, err);
    if (result == 0 && plan->only)
        result = keep_only(plan, &subject.known, err);
    subject.findings = calloc((size_t)subject.known.count + 1, sizeof *subject.findings);
    if (!subject.findings) {
        error_set(err, "out of memory");
        result = -1;
    }
    if (result == 0)
        open_stamps(plan, &subject);
    for (int i = 0; i < subject.known.count && result == 0; i++) {
        subject.findings[i].is_to_do = !subject.findings[i].is_as_before;
        if (plan->brief)
            subject.findings[i].left_out =
                expectation_left_out(&subject.known.submissions[i].expected);
    }
    while (result == 0 && has_to_do(&subject))
        result = grade(plan, &subject, err);
    for (int i = 0; i < subject.known.count && result == 0; i++) {
        plan->met += subject.findings[i].is_met;
        plan->missed += !subject.findings[i].is_met;
        plan->as_before += subject.findings[i].is_as_before;
        if (plan->verbose && subject.findings[i].is_as_before)
            printf("as before: %s %s\n", exercise->name, subject.known.submissions[i].file);
    }
    if (result == 0 && !plan->only)
        check_set(plan, &subject);
    free(subject.findings);
    known_release(&subject.known);
    return result;
}

static int run_plan(struct plan *plan, const struct exercise *exercises, int count,
                    const char *name)
{
    struct error err = {""};
    int result = 0;
    if (!plan->folder && stamps_machine(plan->machine, &err) != 0) {
        fprintf(stderr, "meshgrade: %s: nothing is remembered\n", err.text);
        err.text[0] = '\0';
    }
    for (int i = 0; i < count && result == 0; i++)
        if (!name || strcmp(exercises[i].name, name) == 0)
            result = plan->folder ? expand(&exercises[i], plan->folder, &err)
                                  : validate(plan, &exercises[i], &err);
    if (plan->is_usage_error) {
        fprintf(stderr, "meshgrade: %s\n", err.text);
        return EXIT_USAGE;
    }
    if (plan->as_before > 0)
        printf("%d of %d as before; --again grades all\n", plan->as_before,
               plan->met + plan->missed);
    if (!plan->folder)
        printf("%d submission%s as expected, %d not\n", plan->met, plural_ending(plan->met),
               plan->missed);
    return result != 0                           ? report_fault(&err)
           : plan->missed > 0 || plan->lacks > 0 ? EXIT_NOT_PASSED
                                                 : EXIT_PASSED;
}

static int run(int argc, char **argv)
{
    const char *jobs_text = NULL, *seed_text = NULL, *compiler = NULL;
    struct error err = {""};
    struct plan plan = {0};
    const struct option_rule rules[] = {
        {"only", 0, "FILE,...", "just these of the exercise: wrong/a,right/b", &plan.only, NULL},
        {"again", 0, NULL, "also what got its verdict before and did not change", NULL,
         &plan.again},
        {"brief", 0, NULL, "of each submission only what decides its verdict; no stamp for it",
         NULL, &plan.brief},
        {"jobs", 'j', "N", "submissions at a time (default: one a core)", &jobs_text, NULL},
        {"seed", 0, "N", "as a class of this seed is graded (default: the published seeds)",
         &seed_text, NULL},
        {"compiler", 0, "GCC", "with this one of the machine, as gcc-11 (default: gcc)", &compiler,
         NULL},
        {"expand", 0, "DIR", "only write the submissions to DIR, each as a whole file",
         &plan.folder, NULL},
        {"verbose", 'v', NULL, "a line also for what is as expected", NULL, &plan.verbose},
        {0}};
    struct exercise *exercises = NULL;
    int count, code = EXIT_USAGE;
    int at = options_parse(&command_validate, rules, argc, argv);
    plan.jobs = options_number("jobs", jobs_text, 1, sysconf(_SC_NPROCESSORS_ONLN));
    if (at < 0 || plan.jobs < 0 || options_seed(seed_text, SEED_PUBLISHED, &plan.seed) != 0)
        return EXIT_USAGE;
    if (compiler && compiler_choose(compiler, &err) != 0) {
        fprintf(stderr, "meshgrade: --compiler: %s\n", err.text);
        return EXIT_USAGE;
    }
    const char *name = at < argc ? argv[at] : NULL;
    if (plan.only && !name) {
        fputs("meshgrade: --only: name the exercise, too\n", stderr);
        return EXIT_USAGE;
    }
    if (load_exercises(&exercises, &count) != 0)
        return EXIT_USAGE;
    if (!name || need_exercise(exercises, count, name))
        code = run_plan(&plan, exercises, count, name);
    free(exercises);
    return code;
}

const struct command command_validate = {"validate", "[EXERCISE]",
                                         "every known-verdict submission gets its verdict", run};
