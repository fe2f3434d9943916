/* One result on a terminal; see terminal.h. The table of marks is in terminal_marks.c. */
#include "graders/report/terminal.h"

#include "graders/report/clean.h"
#include "graders/report/diagnostics.h"
#include "graders/report/results.h"
#include "graders/report/terminal_text.h"
#include "reference/base/plural.h"

#include <stdlib.h>
#include <string.h>

/* ---------------------------------------------------------------- the first three lines */

/* The rejected case that explains the verdict: the first with it, else NULL. */
static const json_t *telling_case(const json_t *result)
{
    size_t i;
    json_t *one;
    json_array_foreach(json_object_get(result, "cases"), i, one)
    {
        if (strcmp(result_text(one, "verdict"), result_text(result, "verdict")) == 0 &&
            strcmp(result_text(one, "cause"), result_text(result, "cause")) == 0)
            return one;
    }
    return NULL;
}

/* The check that explains the verdict, when no case does. */
static const json_t *telling_check(const json_t *result)
{
    size_t i;
    json_t *check;
    json_array_foreach(json_object_get(result, "checks"), i, check)
    {
        if (strcmp(result_text(check, "verdict"), result_text(result, "verdict")) == 0)
            return check;
    }
    return NULL;
}

static struct phrase class_title(const json_t *result, const char *name)
{
    size_t i;
    json_t *part;
    json_array_foreach(json_object_get(result, "classes"), i, part)
    {
        if (strcmp(result_text(part, "name"), name) == 0)
            return words_in(part, "title");
    }
    return (struct phrase){name, name};
}

static void put_where(FILE *to, const json_t *result, const struct terminal_style *style)
{
    const json_t *one = telling_case(result);
    const json_t *check = telling_check(result);
    char place[700];
    const char *element = phrase_text(words_in(one, "element"), style->language);
    if (one)
        snprintf(place, sizeof place, "%s%s%s %s (%s)", element, *element ? ", " : "",
                 phrase_text((struct phrase){"case", "caso"}, style->language),
                 result_text(one, "name"),
                 phrase_text(class_title(result, result_text(one, "class")), style->language));
    else if (strcmp(result_text(result, "verdict"), "compile-error") == 0)
        diagnostics_telling_line(result_text(json_object_get(result, "build"), "diagnostics"),
                                 place, sizeof place);
    else
        snprintf(place, sizeof place, "%s",
                 phrase_text(check ? words_in(check, "title") : words_in(result, "title"),
                             style->language));
    terminal_line(to, phrase_text((struct phrase){"  where   ", "  dónde   "}, style->language),
                  place, TERMINAL_COLUMNS);
}

static void put_again(FILE *to, const json_t *result, const struct terminal_style *style)
{
    const json_t *one = telling_case(result);
    char command[700];
    if (one)
        snprintf(command, sizeof command, "%s", result_text(one, "reproduce"));
    else
        snprintf(command, sizeof command, "meshgrade check %s FILE...",
                 result_text(result, "exercise"));
    /* Never cut: it is there to be copied. */
    terminal_line(to, phrase_text((struct phrase){"  again   ", "  repetir "}, style->language),
                  command, sizeof command);
}

/* What is wrong, in one line: the verdict and the first sentence, or the sentence alone when both
 * do not fit. Returns whether that was all there is to say. */
static bool put_what(FILE *to, const char *verdict, const char *message,
                     const struct terminal_style *style)
{
    char start[128];
    char sentence[700];
    enum standing standing = words_standing(verdict);
    size_t length = terminal_sentence(message);
    snprintf(sentence, sizeof sentence, "%.*s", (int)length, message);
    snprintf(start, sizeof start, "%s %s: ", words_symbol(standing),
             phrase_text(words_verdict(verdict), style->language));
    if (clean_columns(start) + clean_columns(sentence) > TERMINAL_COLUMNS)
        snprintf(start, sizeof start, "%s ", words_symbol(standing));
    terminal_colour(to, style, standing);
    bool whole = terminal_line(to, start, sentence, TERMINAL_COLUMNS);
    terminal_plain(to, style);
    return whole && message[length] == '\0';
}

static void put_head(FILE *to, const json_t *result, const struct terminal_style *style)
{
    const char *verdict = result_text(result, "verdict");
    const json_t *one = telling_case(result);
    const char *message =
        phrase_text(words_in(one ? one : result, one ? "message" : "summary"), style->language);
    if (!*message)
        message = phrase_text(words_in(result, "summary"), style->language);
    bool told = put_what(to, verdict, message, style);
    if (words_standing(verdict) == STANDING_PASSED)
        return;
    put_where(to, result, style);
    put_again(to, result, style);
    if (!told) {
        fputc('\n', to);
        terminal_paragraph(to, "  ", message);
    }
}

/* ---------------------------------------------------------------- points */

/* "✓ Closed meshes              4 of 4      2 / 2" */
static void put_row(FILE *to, const struct terminal_style *style, enum standing standing,
                    struct phrase title, const char *middle, const json_t *part)
{
    char given[32];
    char possible[32];
    char points[80];
    words_of_points(result_number(part, "points"), given, sizeof given);
    words_of_points(result_number(part, "max_points"), possible, sizeof possible);
    snprintf(points, sizeof points, "%s / %s", given, possible);
    fputs("  ", to);
    terminal_colour(to, style, standing);
    fputs(words_symbol(standing), to);
    terminal_plain(to, style);
    fputc(' ', to);
    terminal_cell(to, phrase_text(title, style->language), 37, false);
    fputs("  ", to);
    terminal_cell(to, middle, 23, false);
    fputs("  ", to);
    terminal_cell(to, points, 11, true);
    fputc('\n', to);
}

static enum standing standing_of_check(const json_t *check)
{
    if (words_standing(result_text(check, "verdict")) == STANDING_ABSENT)
        return STANDING_ABSENT;
    if (result_number(check, "points") >= result_number(check, "max_points"))
        return STANDING_PASSED;
    return result_number(check, "points") > 0 ? STANDING_PARTIAL : STANDING_FAILED;
}

static void put_points(FILE *to, const json_t *result, const struct terminal_style *style)
{
    size_t i;
    json_t *part;
    json_array_foreach(json_object_get(result, "classes"), i, part)
    {
        struct message tally;
        long long cases = json_integer_value(json_object_get(part, "cases"));
        result_class_tally(result, part, &tally);
        if (cases > 0 && result_not_run(result, result_text(part, "name")).count == 0)
            message_add(&tally, " case%s", " caso%s", plural_ending(cases));
        put_row(to, style, result_class_standing(result, part), words_in(part, "title"),
                message_text(&tally, style->language), part);
    }
    json_array_foreach(json_object_get(result, "checks"), i, part)
    {
        put_row(to, style, standing_of_check(part), words_in(part, "title"),
                phrase_text(words_verdict(result_text(part, "verdict")), style->language), part);
    }
}

static void put_quality(FILE *to, const json_t *result, const struct terminal_style *style)
{
    const json_t *quality = json_object_get(json_object_get(result, "measures"), "quality");
    struct message measured, line;
    if (!quality)
        return;
    words_of_quality(quality, &measured);
    message_set_phrase(&line, (struct phrase){"quality: ", "calidad: "});
    message_add_phrase(&line, message_phrase(&measured));
    terminal_paragraph(to, "  ", message_text(&line, style->language));
}

static void put_score(FILE *to, const json_t *result, const struct terminal_style *style)
{
    char title[300];
    char points[80];
    snprintf(title, sizeof title, "%s %s", result_text(result, "problem"),
             phrase_text(words_in(result, "title"), style->language));
    if (result_standing(result) == STANDING_UNSCORED) {
        snprintf(points, sizeof points, "%s",
                 phrase_text((struct phrase){"not scored", "sin nota"}, style->language));
    } else {
        char given[32];
        char possible[32];
        words_of_points(result_number(result, "score"), given, sizeof given);
        words_of_points(result_number(result, "max_score"), possible, sizeof possible);
        snprintf(points, sizeof points, "%s / %s", given, possible);
    }
    fputc('\n', to);
    if (style->colour)
        fputs("\033[1m", to);
    terminal_cell(to, title, 64, false);
    fputs("  ", to);
    terminal_cell(to, points, 13, true);
    terminal_plain(to, style);
    fputc('\n', to);
}

/* ---------------------------------------------------------------- the rest */

/* Whether a check says why it gave no points: it failed, a tool could not finish it, or a call that
 * it rests on went wrong. That something before it failed is no reason of its own. */
static bool tells_why(const json_t *check)
{
    static const char *const told_elsewhere[] = {"no-valgrind", "not-reached", "basic-class", ""};
    const char *verdict = result_text(check, "verdict");
    if (words_standing(verdict) != STANDING_ABSENT)
        return words_standing(verdict) == STANDING_FAILED;
    for (size_t i = 0; i < sizeof told_elsewhere / sizeof *told_elsewhere; i++)
        if (strcmp(result_text(check, "cause"), told_elsewhere[i]) == 0)
            return false;
    return true;
}

/* Checks without points say why. What the first lines told, or the check before, is not said again.
 */
static void put_check_messages(FILE *to, const json_t *result, const struct terminal_style *style)
{
    size_t i;
    json_t *check;
    const char *last = "";
    const json_t *told = telling_case(result) ? NULL : telling_check(result);
    json_array_foreach(json_object_get(result, "checks"), i, check)
    {
        const char *message = phrase_text(words_in(check, "message"), style->language);
        if (check == told || !tells_why(check) || strcmp(message, last) == 0)
            continue;
        fputs(*last ? "" : "\n", to);
        last = message;
        terminal_paragraph(to, "  ", message);
    }
}

static void put_other_cases(FILE *to, const json_t *result, const struct terminal_style *style)
{
    enum { SHOWN = 5 };
    const json_t *told = telling_case(result);
    size_t count = 0;
    size_t i;
    json_t *one;
    json_array_foreach(json_object_get(result, "cases"), i, one)
    {
        if (one == told || words_standing(result_text(one, "verdict")) != STANDING_FAILED)
            continue;
        if (count == 0)
            fputs(phrase_text(
                      (struct phrase){"\nOther rejected cases\n", "\nOtros casos rechazados\n"},
                      style->language),
                  to);
        if (count++ >= SHOWN)
            continue;
        char start[200];
        char sentence[700];
        const char *message = phrase_text(words_in(one, "message"), style->language);
        snprintf(start, sizeof start, "  %s: ", result_text(one, "name"));
        snprintf(sentence, sizeof sentence, "%.*s", (int)terminal_sentence(message), message);
        terminal_line(to, start, sentence, TERMINAL_COLUMNS);
    }
    if (count > SHOWN) {
        struct message more;
        message_say(&more, "and %zu more", "y %zu más", count - SHOWN);
        fprintf(to, "  %s\n", message_text(&more, style->language));
    }
}

static void put_diagnostics(FILE *to, const json_t *result, const struct terminal_style *style)
{
    const json_t *build = json_object_get(result, "build");
    const json_t *diagnostics = json_object_get(build, "diagnostics");
    if (json_is_true(json_object_get(build, "ok")) || json_string_length(diagnostics) == 0)
        return;
    fputs(
        phrase_text((struct phrase){"\nWhat the compiler said\n", "\nLo que dijo el compilador\n"},
                    style->language),
        to);
    terminal_block(to, "  ", diagnostics, 12);
}

/* Why cases were left out. */
static void put_not_run(FILE *to, const json_t *result, const struct terminal_style *style)
{
    struct not_run not_run = result_not_run(result, NULL);
    if (not_run.count == 0)
        return;
    fputc('\n', to);
    terminal_paragraph(to, "  ", phrase_text(not_run.reason, style->language));
}

static void put_not_measured(FILE *to, const json_t *result, const struct terminal_style *style)
{
    size_t i;
    json_t *probe;
    json_array_foreach(json_object_get(result, "not_measured"), i, probe)
    {
        struct phrase name = words_in(probe, "name"), reason = words_in(probe, "reason");
        struct message text;
        message_clear(&text);
        message_en(&text, "Not measured: %s: %s", name.en, reason.en);
        message_es(&text, "No medido: %s: %s", name.es, reason.es);
        fputs(i == 0 ? "\n" : "", to);
        terminal_paragraph(to, "  ", message_text(&text, style->language));
    }
}

void terminal_print_result(FILE *to, const json_t *result, const struct terminal_style *style)
{
    put_head(to, result, style);
    put_score(to, result, style);
    put_points(to, result, style);
    put_quality(to, result, style);
    put_diagnostics(to, result, style);
    put_not_run(to, result, style);
    put_check_messages(to, result, style);
    put_other_cases(to, result, style);
    put_not_measured(to, result, style);
}
