/* Moodle VPL: what vpl_execution prints. Text of others stands only in comment blocks, each line of
 * it behind a '>' and with every ":=>>" and "--|>" broken up; the grade is the last line. So
 * nothing that a student wrote can pass for a grade, whichever way VPL looks for it. */
#include "graders/report/export.h"

#include "graders/report/clean.h"

#include <stdlib.h>
#include <string.h>

/* Writes a text as preformatted lines. */
static int put_lines(FILE *to, const char *text, size_t length)
{
    static const char *const tags[] = {":=>>", "--|>", "<|--"};
    char *clean = clean_text(text, length, CLEAN_BLOCK, 4000);
    if (!clean)
        return -1;
    fputc('>', to);
    for (const char *c = clean; *c; c++) {
        for (size_t i = 0; i < sizeof tags / sizeof *tags; i++)
            if (strncmp(c, tags[i], strlen(tags[i])) == 0) {
                fprintf(to, "%c ", *c++);
                break;
            }
        fputc(*c, to);
        if (*c == '\n' && c[1])
            fputc('>', to);
    }
    if (*clean == '\0' || clean[strlen(clean) - 1] != '\n')
        fputc('\n', to);
    free(clean);
    return 0;
}

static int put_json(FILE *to, const json_t *string)
{
    return json_string_length(string) == 0
               ? 0
               : put_lines(to, json_string_value(string), json_string_length(string));
}

static int put_words(const struct export_job *job, struct phrase words)
{
    const char *text = phrase_text(words, job->language);
    return *text ? put_lines(job->to, text, strlen(text)) : 0;
}

/* A title line: our own words and names only. */
static void put_title(const struct export_job *job, const json_t *result)
{
    char score[32];
    char max_score[32];
    words_of_points(result_number(result, "score"), score, sizeof score);
    words_of_points(result_number(result, "max_score"), max_score, sizeof max_score);
    fprintf(job->to, "-%s: %s (", result_text(result, "exercise"),
            phrase_text(words_verdict(result_text(result, "verdict")), job->language));
    if (result_standing(result) == STANDING_UNSCORED)
        fputs(phrase_text((struct phrase){"not scored)\n", "sin nota)\n"}, job->language), job->to);
    else
        fprintf(job->to, "%s / %s)\n", score, max_score);
}

static int put_result(const struct export_job *job, const json_t *result)
{
    enum { CASES_SHOWN = 5 };
    size_t i;
    json_t *one;
    size_t shown = 0;
    put_title(job, result);
    if (put_words(job, words_in(result, "summary")) != 0 ||
        put_json(job->to, json_object_get(json_object_get(result, "build"), "diagnostics")) != 0)
        return -1;
    json_array_foreach(json_object_get(result, "cases"), i, one)
    {
        if (words_standing(result_text(one, "verdict")) != STANDING_FAILED ||
            shown++ >= CASES_SHOWN)
            continue;
        if (put_words(job, words_in(one, "message")) != 0 ||
            put_words(job, words_in(one, "element")) != 0 ||
            put_json(job->to, json_object_get(one, "reproduce")) != 0)
            return -1;
    }
    json_array_foreach(json_object_get(result, "checks"), i, one)
    {
        if (words_standing(result_text(one, "verdict")) == STANDING_FAILED &&
            put_words(job, words_in(one, "message")) != 0)
            return -1;
    }
    return 0;
}

int export_vpl(const struct export_job *job, struct error *err)
{
    if (job->book->student_count != 1)
        return error_set(err, "vpl takes one student; choose one with --student NAME");
    const struct student *student = &job->book->students[0];
    fputs("<|--\n", job->to);
    for (size_t e = 0; e < job->book->exercise_count; e++)
        if (student->results[e] && put_result(job, student->results[e]) != 0)
            return error_set(err, "out of memory for VPL's comments");
    fputs("--|>\n", job->to);
    char total[32];
    words_of_points(student->score, total, sizeof total);
    if (student->unscored == 0)
        fprintf(job->to, "Grade :=>> %s\n", total);
    else
        fprintf(job->to, "Comment :=>> %s\n",
                phrase_text((struct phrase){"Not scored: a person must look.",
                                            "Sin nota: debe mirarlo una persona."},
                            job->language));
    return 0;
}
