/* Gradescope's results.json: each class of input and each check of an exercise is a test.
 *
 * The score at the top counts, so that a test may be without one: an answer that is not scored
 * (fault, flagged) gives neither points nor a lost point, and the total is then kept from the
 * student until staff have looked. */
#include "graders/report/export.h"

#include "graders/report/clean.h"

#include <stdlib.h>
#include <string.h>

static json_t *clean_string(const char *text)
{
    char *clean = clean_text(text, strlen(text), CLEAN_BLOCK, 20000);
    json_t *string = clean ? json_string(clean) : NULL;
    free(clean);
    return string;
}

/* What a student reads below a class: the messages of its rejected cases. */
static json_t *class_output(const json_t *result, const json_t *part, enum language language)
{
    char *text = NULL;
    size_t length = 0;
    FILE *to = open_memstream(&text, &length);
    if (!to)
        return NULL;
    size_t i;
    json_t *one;
    json_array_foreach(json_object_get(result, "cases"), i, one)
    {
        if (strcmp(result_text(one, "class"), result_text(part, "name")) != 0 ||
            words_standing(result_text(one, "verdict")) != STANDING_FAILED)
            continue;
        fprintf(to, "%s: %s\n", result_text(one, "name"),
                phrase_text(words_in(one, "message"), language));
        const char *element = phrase_text(words_in(one, "element"), language);
        if (*element)
            fprintf(to, "  %s\n", element);
        fprintf(to, "  %s\n", result_text(one, "reproduce"));
    }
    json_t *output = fclose(to) == 0 ? clean_string(text) : NULL;
    free(text);
    return output;
}

static json_t *test_of(const char *number, const char *name, const json_t *part, bool is_scored,
                       json_t *output)
{
    double points = result_number(part, "points");
    double max_points = result_number(part, "max_points");
    json_t *test =
        json_pack("{s:s, s:s, s:f, s:o, s:s, s:s}", "number", number, "name", name, "max_score",
                  max_points, "output", output, "output_format", "text", "visibility", "visible");
    if (test && is_scored) {
        json_object_set_new(test, "score", json_real(points));
        json_object_set_new(test, "status",
                            json_string(points >= max_points ? "passed" : "failed"));
    }
    return test;
}

static int add_parts(json_t *tests, const struct export_job *job, size_t exercise,
                     const json_t *result, const char *key)
{
    size_t i;
    json_t *part;
    json_array_foreach(json_object_get(result, key), i, part)
    {
        char number[32];
        char name[600];
        bool is_class = strcmp(key, "classes") == 0;
        snprintf(number, sizeof number, "%zu.%zu", exercise + 1, json_array_size(tests) + 1);
        snprintf(name, sizeof name, "%s: %s", result_text(result, "exercise"),
                 phrase_text(words_in(part, "title"), job->language));
        json_t *output = is_class
                             ? class_output(result, part, job->language)
                             : clean_string(phrase_text(words_in(part, "message"), job->language));
        bool is_scored = result_standing(result) != STANDING_UNSCORED;
        if (!output ||
            json_array_append_new(tests, test_of(number, name, part, is_scored, output)) != 0)
            return -1;
    }
    return 0;
}

/* One line an exercise: its verdict and the sentence. */
static json_t *summary_of(const struct export_job *job, const struct student *student)
{
    char *text = NULL;
    size_t length = 0;
    FILE *to = open_memstream(&text, &length);
    if (!to)
        return NULL;
    for (size_t e = 0; e < job->book->exercise_count; e++) {
        const json_t *result = student->results[e];
        if (result)
            fprintf(to, "%s: %s. %s\n", job->book->exercises[e].name,
                    phrase_text(words_verdict(result_text(result, "verdict")), job->language),
                    phrase_text(words_in(result, "summary"), job->language));
    }
    json_t *output = fclose(to) == 0 ? clean_string(text) : NULL;
    free(text);
    return output;
}

static json_t *results_of(const struct export_job *job, const struct student *student)
{
    json_t *tests = json_array();
    json_t *output = summary_of(job, student);
    bool is_complete = tests && output;
    for (size_t e = 0; is_complete && e < job->book->exercise_count; e++)
        if (student->results[e])
            is_complete = add_parts(tests, job, e, student->results[e], "classes") == 0 &&
                          add_parts(tests, job, e, student->results[e], "checks") == 0;
    if (!is_complete) {
        json_decref(tests);
        json_decref(output);
        return NULL;
    }
    return json_pack("{s:f, s:o, s:s, s:s, s:s, s:o, s:{s:i}}", "score", student->score, "output",
                     output, "output_format", "text", "visibility",
                     student->unscored > 0 ? "hidden" : "visible", "stdout_visibility", "hidden",
                     "tests", tests, "extra_data", "not_scored", student->unscored);
}

/* Students by name; where two bear the same, the folder stands behind it. */
static int add_student(json_t *all, const struct student *student, json_t *results)
{
    char *name = export_clean(student->name, false);
    char *key = NULL;
    if (name && json_object_get(all, name) && asprintf(&key, "%s (%s)", name, student->folder) < 0)
        key = NULL;
    bool needs_key = name && json_object_get(all, name);
    int status = -1;
    if (name && results && (key || !needs_key))
        status = json_object_set_new(all, key ? key : name, results);
    else
        json_decref(results);
    free(key);
    free(name);
    return status;
}

int export_gradescope(const struct export_job *job, struct error *err)
{
    json_t *all = NULL;
    int status = 0;
    if (job->one_student) {
        all = results_of(job, &job->book->students[0]);
    } else {
        all = json_object();
        for (size_t s = 0; all && status == 0 && s < job->book->student_count; s++)
            status =
                add_student(all, &job->book->students[s], results_of(job, &job->book->students[s]));
    }
    if (!all || status != 0 ||
        json_dumpf(all, job->to, JSON_INDENT(1) | JSON_ENSURE_ASCII | JSON_REAL_PRECISION(15)) != 0)
        status = error_set(err, "out of memory for Gradescope's results");
    fputc('\n', job->to);
    json_decref(all);
    return status;
}
