/* JUnit XML: a suite for each student and exercise, a test case for each case and each check. What
 * the student answered wrong is a failure, a fault of ours an error, what was not run or measured
 * skipped. Times are left out: results hold no clock. */
#include "graders/report/export.h"

#include "graders/report/clean.h"

#include <stdlib.h>
#include <string.h>

/* Cleaned text is valid XML 1.0 but for its markup. In an attribute a line break would become a
 * blank. */
static void put_escaped(FILE *to, const char *text)
{
    for (const char *c = text; *c; c++) {
        switch (*c) {
        case '&':
            fputs("&amp;", to);
            break;
        case '<':
            fputs("&lt;", to);
            break;
        case '>':
            fputs("&gt;", to);
            break;
        case '"':
            fputs("&quot;", to);
            break;
        case '\n':
            fputs("&#10;", to);
            break;
        default:
            fputc(*c, to);
        }
    }
}

static void put_bytes(FILE *to, const char *text, size_t length, bool keep_lines)
{
    char *clean = clean_text(text, length, keep_lines ? CLEAN_BLOCK : CLEAN_LINE, 20000);
    if (clean)
        put_escaped(to, clean);
    else
        put_escaped(to, "(out of memory)");
    free(clean);
}

static void put_json(FILE *to, const json_t *string, bool keep_lines)
{
    put_bytes(to, json_string_value(string), json_string_length(string), keep_lines);
}

static void put_attribute(FILE *to, const char *name, const char *text)
{
    fprintf(to, " %s=\"", name);
    put_bytes(to, text, strlen(text), false);
    fputc('"', to);
}

/* The child that says how a test case ended; nothing when it passed. */
static void write_end(const struct export_job *job, const json_t *part, struct phrase message)
{
    const char *verdict = result_text(part, "verdict");
    const char *element = NULL;
    switch (words_standing(verdict)) {
    case STANDING_FAILED:
        element = "failure";
        break;
    case STANDING_UNSCORED:
        element = strcmp(verdict, "fault") == 0 ? "error" : "skipped";
        break;
    case STANDING_ABSENT:
        element = "skipped";
        break;
    default:
        return;
    }
    fprintf(job->to, "   <%s", element);
    if (strcmp(element, "skipped") != 0)
        put_attribute(job->to, "type", verdict);
    put_attribute(job->to, "message",
                  *message.en ? phrase_text(message, job->language)
                              : phrase_text(words_verdict(verdict), job->language));
    fputc('>', job->to);
    if (*result_text(part, "reproduce"))
        put_json(job->to, json_object_get(part, "reproduce"), false);
    fprintf(job->to, "</%s>\n", element);
}

static void write_case(const struct export_job *job, const json_t *result, const char *class_name,
                       const json_t *part, struct phrase message)
{
    fprintf(job->to, "  <testcase classname=\"%s.%s\" name=\"%s\">\n",
            result_text(result, "exercise"), class_name, result_text(part, "name"));
    write_end(job, part, message);
    fputs("  </testcase>\n", job->to);
}

/* A result that ended before its cases (it did not compile, the grader failed) is a case of its
 * own. */
static bool needs_case_of_its_own(const json_t *result)
{
    const char *verdict = result_text(result, "verdict");
    return strcmp(verdict, "compile-error") == 0 || words_standing(verdict) == STANDING_UNSCORED;
}

static const char *const kinds[] = {"failure", "error", "skipped"};

static void count_part(const json_t *part, size_t *counts)
{
    const char *verdict = result_text(part, "verdict");
    enum standing standing = words_standing(verdict);
    counts[0] += standing == STANDING_FAILED;
    counts[1] += strcmp(verdict, "fault") == 0;
    counts[2] += standing == STANDING_ABSENT || strcmp(verdict, "flagged") == 0;
}

static void write_suite_start(const struct export_job *job, const struct student *student,
                              const json_t *result)
{
    size_t counts[sizeof kinds / sizeof *kinds] = {0};
    const json_t *cases = json_object_get(result, "cases");
    const json_t *checks = json_object_get(result, "checks");
    size_t tests = json_array_size(cases) + json_array_size(checks) + needs_case_of_its_own(result);
    for (size_t i = 0; i < json_array_size(cases); i++)
        count_part(json_array_get(cases, i), counts);
    for (size_t i = 0; i < json_array_size(checks); i++)
        count_part(json_array_get(checks, i), counts);
    if (needs_case_of_its_own(result))
        count_part(result, counts);
    fputs(" <testsuite name=\"", job->to);
    put_json(job->to, student->name, false);
    fprintf(job->to, "/%s\" tests=\"%zu\" failures=\"%zu\" errors=\"%zu\" skipped=\"%zu\">\n",
            result_text(result, "exercise"), tests, counts[0], counts[1], counts[2]);
    char score[32];
    fputs("  <properties>\n", job->to);
    if (json_is_number(json_object_get(result, "score"))) {
        words_of_points(result_number(result, "score"), score, sizeof score);
        fprintf(job->to, "   <property name=\"score\" value=\"%s\"/>\n", score);
    }
    words_of_points(result_number(result, "max_score"), score, sizeof score);
    fprintf(job->to, "   <property name=\"max_score\" value=\"%s\"/>\n", score);
    fprintf(job->to, "   <property name=\"verdict\" value=\"%s\"/>\n",
            result_text(result, "verdict"));
    fputs("  </properties>\n", job->to);
}

static void write_suite(const struct export_job *job, const struct student *student,
                        const json_t *result)
{
    size_t i;
    json_t *part;
    write_suite_start(job, student, result);
    if (needs_case_of_its_own(result)) {
        fprintf(job->to, "  <testcase classname=\"%s\" name=\"verdict\">\n",
                result_text(result, "exercise"));
        write_end(job, result, words_in(result, "summary"));
        fputs("  </testcase>\n", job->to);
    }
    json_array_foreach(json_object_get(result, "cases"), i, part)
    {
        write_case(job, result, result_text(part, "class"), part, words_in(part, "message"));
    }
    json_array_foreach(json_object_get(result, "checks"), i, part)
    {
        write_case(job, result, "checks", part, words_in(part, "message"));
    }
    fputs("  <system-out>", job->to);
    put_json(job->to, json_object_get(result, "output"), true);
    fputs("</system-out>\n  <system-err>", job->to);
    put_json(job->to, json_object_get(json_object_get(result, "build"), "diagnostics"), true);
    fputs("</system-err>\n </testsuite>\n", job->to);
}

int export_junit(const struct export_job *job, struct error *err)
{
    (void)err; /* what can fail is the stream, which the caller checks */
    fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"meshgrade\">\n", job->to);
    for (size_t s = 0; s < job->book->student_count; s++)
        for (size_t e = 0; e < job->book->exercise_count; e++)
            if (job->book->students[s].results[e])
                write_suite(job, &job->book->students[s], job->book->students[s].results[e]);
    fputs("</testsuites>\n", job->to);
    return 0;
}
