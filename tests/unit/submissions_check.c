/* An exercise's answers and its judge against each other; see submissions.h. */
#include "tests/unit/submissions.h"

#include <dirent.h>
#include <jansson.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { CLASS_LIMIT = 24, PATH_BYTES = 512, COMMENT_BYTES = 2048, FAILING_LIMIT = 24 };

/* A check of one exercise in progress. Sets of classes are bits. */
struct check {
    const struct judge *judge;
    const char *group;
    json_t *manifest;
    const char *class_name[CLASS_LIMIT];
    int class_count;
    uint32_t witnessed; /* classes that some submission fails alone */
    int complaint_count;
};

static void complain(struct check *check, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void complain(struct check *check, const char *format, ...)
{
    char line[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    print_error("%s: %s\n", check->judge->exercise, line);
    check->complaint_count++;
}

static int class_index(const struct check *check, const char *name, size_t length)
{
    for (int i = 0; i < check->class_count; i++)
        if (strlen(check->class_name[i]) == length &&
            strncmp(check->class_name[i], name, length) == 0)
            return i;
    return -1;
}

/* ----------------------------------------------------------------- manifest */

static double points_of(const json_t *manifest, const char *key)
{
    return json_number_value(json_object_get(json_object_get(manifest, key), "points"));
}

static void check_manifest(struct check *check)
{
    static const char *const checks[] = {
        "growth", "work", "memory", "leak", "undefined-behaviour", "allocation-failure"};
    double points = 0;
    size_t index;
    const json_t *entry;
    json_array_foreach(json_object_get(check->manifest, "classes"), index, entry)
    {
        assert_true(check->class_count < CLASS_LIMIT);
        check->class_name[check->class_count++] = json_string_value(json_object_get(entry, "name"));
        points += json_number_value(json_object_get(entry, "points"));
    }
    for (size_t i = 0; i < sizeof checks / sizeof *checks; i++)
        points += points_of(check->manifest, checks[i]);
    if (fabs(points - 10) > 1e-9)
        complain(check, "the points sum to %g, not to 10", points);
    uint32_t used = 0;
    for (size_t i = 0; i < check->judge->case_count; i++) {
        const char *name = check->judge->cases[i].class_name;
        int class = class_index(check, name, strlen(name));
        if (class < 0)
            complain(check, "case %s is of class %s, which exercise.json does not name",
                     check->judge->cases[i].name, name);
        else
            used |= 1u << class;
    }
    for (int i = 0; i < check->class_count; i++)
        if (!(used >> i & 1))
            complain(check, "class %s has no case", check->class_name[i]);
}

/* -------------------------------------------------------------------- cases */

struct outcome {
    uint32_t failed; /* classes */
    bool left_something, freed_wildly;
    char first_failure[1024];
};

/* Runs and judges one input; returns whether the answer is accepted. `why` gets the reason if not.
 */
static bool run_and_judge(const struct check *check, const struct submission *submission,
                          const struct writer *input, struct outcome *outcome, char *why,
                          size_t why_bytes)
{
    struct span span = {input->bytes, input->count};
    struct submission_answer answer;
    struct judgement judgement = {0};
    struct error err = {0};
    submission_run(submission, span, judge_answer_bound(check->judge, span), 0, &answer);
    outcome->left_something |= answer.usage.heap_left_bytes != 0;
    outcome->freed_wildly |= answer.bad_free_count != 0;
    if (answer.end == SUBMISSION_ANSWERED) {
        struct span bytes = {answer.bytes, answer.count};
        if (judge_answer(check->judge, span, bytes, &answer.usage, &judgement, &err))
            fail_msg("%s: the judge failed: %s", check->judge->exercise, err.text);
        if (!judgement.accepted && !(judgement.cause[0] && judgement.message.es[0]))
            fail_msg("%s: rejected without a reason", check->judge->exercise);
        snprintf(why, why_bytes, "%s [%s]: %s", judgement.cause, judgement.element.en,
                 judgement.message.en);
    } else {
        snprintf(why, why_bytes, answer.end == SUBMISSION_DIED ? "died" : "ran out of memory");
    }
    json_t *scene = scene_to_json(&judgement.scene);
    assert_non_null(scene);
    json_decref(scene);
    scene_release(&judgement.scene);
    submission_answer_release(&answer);
    return judgement.accepted;
}

static void run_cases(const struct check *check, const struct submission *submission,
                      struct outcome *outcome)
{
    *outcome = (struct outcome){0};
    for (size_t i = 0; i < check->judge->case_count; i++) {
        const struct judge_case *c = &check->judge->cases[i];
        struct writer input = writer_growing();
        struct error err = {0};
        char why[800];
        if (judge_make(check->judge, c, "exercises/models", &input, &err))
            fail_msg("%s: case %s cannot be made: %s", check->judge->exercise, c->name, err.text);
        if (!run_and_judge(check, submission, &input, outcome, why, sizeof why)) {
            int class = class_index(check, c->class_name, strlen(c->class_name));
            outcome->failed |= class >= 0 ? 1u << class : 0;
            if (!outcome->first_failure[0])
                snprintf(outcome->first_failure, sizeof outcome->first_failure, "case %s, %s",
                         c->name, why);
            if (getenv("SUBMISSIONS_VERBOSE"))
                print_message("    %s: %s\n", c->name, why);
        }
        writer_release(&input);
    }
}

/* Every allocation of every case fails once: the submission must say that memory ran out, or do
 * without, and leave nothing behind. */
static void check_failing_allocations(struct check *check, const struct submission *submission,
                                      const char *source)
{
    for (size_t i = 0; i < check->judge->case_count; i++) {
        const struct judge_case *c = &check->judge->cases[i];
        struct writer input = writer_growing();
        struct error err = {0};
        assert_int_equal(judge_make(check->judge, c, "exercises/models", &input, &err), 0);
        struct span span = {input.bytes, input.count};
        for (int64_t failing = 1; failing <= FAILING_LIMIT; failing++) {
            struct submission_answer answer;
            submission_run(submission, span, judge_answer_bound(check->judge, span), failing, &answer);
            bool reached = answer.usage.allocation_count >= failing;
            if (answer.end == SUBMISSION_DIED || answer.usage.heap_left_bytes ||
                answer.bad_free_count)
                complain(check, "%s, case %s: allocation %d fails: %s", source, c->name,
                         (int)failing, answer.end == SUBMISSION_DIED ? "it dies" : "it leaks");
            submission_answer_release(&answer);
            if (!reached)
                break;
        }
        writer_release(&input);
    }
}

static void check_sizes(struct check *check, const struct submission *submission)
{
    const json_t *growth = json_object_get(check->manifest, "growth");
    int64_t first = json_integer_value(json_object_get(growth, "first_size"));
    if ((growth != NULL) != (check->judge->families != NULL))
        complain(check, "the judge has families if and only if exercise.json counts growth");
    for (int f = 0; growth && f < judge_family_count(check->judge); f++) {
        for (int64_t size = first; size <= 4 * first; size *= 2) {
            struct writer input = writer_growing();
            struct error err = {0};
            struct outcome outcome = {0};
            char why[800];
            if (judge_make_sized(check->judge, f, size, 7, &input, &err))
                complain(check, "size %d of %s: %s", (int)size, judge_family_name(check->judge, f),
                         err.text);
            else if (!run_and_judge(check, submission, &input, &outcome, why, sizeof why))
                complain(check, "size %d of %s: %s", (int)size, judge_family_name(check->judge, f), why);
            writer_release(&input);
        }
    }
}

/* -------------------------------------------------------------- expectations */

/* The rest of the line that follows `key` in the file's first comment, or "". */
static void read_header_line(const char *source, const char *key, char *line, size_t line_bytes)
{
    char comment[COMMENT_BYTES] = "";
    line[0] = '\0';
    FILE *file = fopen(source, "r");
    assert_non_null(file);
    comment[fread(comment, 1, sizeof comment - 1, file)] = '\0';
    fclose(file);
    char *end = strstr(comment, "*/");
    if (end)
        *end = '\0';
    const char *at = strstr(comment, key);
    if (at)
        snprintf(line, line_bytes, "%.*s", (int)strcspn(at + strlen(key), "\n"), at + strlen(key));
}

/* The classes named in "open, several-components, growth"; checks are no classes and left out. */
static uint32_t classes_in(const struct check *check, const char *line)
{
    uint32_t set = 0;
    while (*line) {
        line += strspn(line, ", ");
        size_t length = strcspn(line, ", ");
        int class = class_index(check, line, length);
        if (class >= 0)
            set |= 1u << class;
        line += length;
    }
    return set;
}

static void name_classes(const struct check *check, uint32_t set, char *text, size_t text_bytes)
{
    size_t at = 0;
    text[0] = '\0';
    for (int i = 0; i < check->class_count && at < text_bytes; i++)
        if (set >> i & 1)
            at += (size_t)snprintf(text + at, text_bytes - at, "%s%s", at ? ", " : "",
                                   check->class_name[i]);
}

static void check_failed_classes(struct check *check, const char *source, bool should_fail,
                                 const struct outcome *outcome)
{
    char fails[512], got[512], want[512];
    read_header_line(source, "fails:", fails, sizeof fails);
    uint32_t expected = classes_in(check, fails);
    name_classes(check, outcome->failed, got, sizeof got);
    name_classes(check, expected, want, sizeof want);
    if ((fails[0] || !should_fail) && outcome->failed != expected)
        complain(check, "%s fails [%s], expected [%s]; %s", source, got, want,
                 outcome->first_failure);
    else if (should_fail && !outcome->failed)
        complain(check, "%s is accepted", source);
    if (outcome->failed && (outcome->failed & (outcome->failed - 1)) == 0)
        check->witnessed |= outcome->failed;
}

static void check_source(struct check *check, const char *folder, const char *source)
{
    struct submission submission;
    struct outcome outcome;
    char expected[64];
    read_header_line(source, "expect: ", expected, sizeof expected);
    bool wrong = strcmp(folder, "wrong") == 0 || strcmp(expected, "wrong-answer") == 0;
    bool right = strcmp(folder, "right") == 0;
    if ((strcmp(folder, "crash") == 0 || strcmp(folder, "hostile") == 0) && !wrong)
        return;
    submission_build(&submission, check->group, check->judge->exercise, source);
    run_cases(check, &submission, &outcome);
    check_failed_classes(check, source, wrong, &outcome);
    if (strcmp(folder, "leak") == 0 && !outcome.left_something)
        complain(check, "%s leaks nothing", source);
    if (right && (outcome.left_something || outcome.freed_wildly))
        complain(check, "%s leaks or frees what it must not", source);
    if (right)
        check_failing_allocations(check, &submission, source);
    submission_release(&submission);
}

static int is_c_file(const struct dirent *entry)
{
    size_t length = strlen(entry->d_name);
    return length > 2 && strcmp(entry->d_name + length - 2, ".c") == 0;
}

static int check_folder(struct check *check, const char *folder)
{
    char path[PATH_BYTES];
    struct dirent **entries = NULL;
    snprintf(path, sizeof path, "tests/submissions/%s/%s/%s", check->group, check->judge->exercise,
             folder);
    int count = scandir(path, &entries, is_c_file, alphasort);
    for (int i = 0; i < count; i++) {
        char source[2 * PATH_BYTES];
        snprintf(source, sizeof source, "%s/%s", path, entries[i]->d_name);
        check_source(check, folder, source);
        free(entries[i]);
    }
    free(entries);
    return count < 0 ? 0 : count;
}

static void check_own_answers(struct check *check)
{
    char source[PATH_BYTES];
    struct submission submission;
    struct outcome outcome;
    snprintf(source, sizeof source, "exercises/%s/%s/starter.c", check->group,
             check->judge->exercise);
    submission_build(&submission, check->group, check->judge->exercise, source);
    run_cases(check, &submission, &outcome);
    if (!(outcome.failed & 1))
        complain(check, "the starter passes the first class");
    submission_release(&submission);
    snprintf(source, sizeof source, "reference/answers/%s/%s.c", check->group,
             check->judge->exercise);
    check_source(check, "right", source);
    submission_build(&submission, check->group, check->judge->exercise, source);
    check_sizes(check, &submission);
    submission_release(&submission);
}

void submissions_check(const struct judge *judge, const char *group)
{
    static const char *const folders[] = {"slow", "greedy", "leak", "crash", "hostile"};
    struct check check = {.judge = judge, .group = group};
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "exercises/%s/%s/exercise.json", group, judge->exercise);
    json_error_t where;
    check.manifest = json_load_file(path, JSON_REJECT_DUPLICATES, &where);
    if (!check.manifest)
        fail_msg("%s:%d: %s", path, where.line, where.text);
    check_manifest(&check);
    check_own_answers(&check);
    if (check_folder(&check, "right") < 3)
        complain(&check, "fewer than 3 right submissions");
    if (check_folder(&check, "wrong") < 6)
        complain(&check, "fewer than 6 wrong submissions");
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++)
        check_folder(&check, folders[i]);
    for (int i = 0; i < check.class_count; i++)
        if (!(check.witnessed >> i & 1))
            complain(&check, "no submission fails just class %s", check.class_name[i]);
    json_decref(check.manifest);
    assert_int_equal(check.complaint_count, 0);
}
