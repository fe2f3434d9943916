/* The page of a student: every exercise with its points, what went wrong and how to see it again.
 */
#include "graders/report/page.h"

#include "graders/report/results.h"
#include "reference/base/plural.h"

#include <string.h>

static void write_overview(struct html *page, const struct gradebook *book,
                           const struct student *student)
{
    html_open(page, "ul");
    html_attribute(page, "class", "overview");
    for (size_t e = 0; e < book->exercise_count; e++) {
        const json_t *result = student->results[e];
        char anchor[160];
        snprintf(anchor, sizeof anchor, "#%s", book->exercises[e].name);
        html_open(page, "li");
        html_attribute(page, "class", words_of_standing(result_standing(result)).en);
        html_open(page, result ? "a" : "div");
        if (result)
            html_path(page, "href", anchor);
        html_leaf(page, "span", "problem", book->exercises[e].problem);
        html_both_leaf(page, "span", "title", book->exercises[e].title);
        if (result) {
            page_score(page, result);
        } else {
            html_open(page, "span");
            html_attribute(page, "class", "score absent");
            page_symbol(page, STANDING_ABSENT);
            html_text(page, " ");
            html_both(page, (struct phrase){"not submitted", "no entregado"});
            html_close(page, "span");
        }
        html_close(page, result ? "a" : "div");
        html_close(page, "li");
    }
    html_close(page, "ul");
}

/* ---------------------------------------------------------------- points */

static enum standing standing_of_points(double points, double max_points, const char *verdict)
{
    if (words_standing(verdict) == STANDING_ABSENT)
        return STANDING_ABSENT;
    if (points >= max_points)
        return STANDING_PASSED;
    return points > 0 ? STANDING_PARTIAL : STANDING_FAILED;
}

static void write_points(struct html *page, double points, double max_points)
{
    char given[32];
    char possible[32];
    words_of_points(points, given, sizeof given);
    words_of_points(max_points, possible, sizeof possible);
    html_open(page, "td");
    html_attribute(page, "class", "points");
    html_leaf(page, "b", NULL, given);
    html_format(page, " / %s", possible);
    html_close(page, "td");
}

static void start_points_table(struct html *page, struct phrase title, struct phrase second)
{
    html_open(page, "table");
    html_attribute(page, "class", "points-table");
    html_open(page, "thead");
    html_open(page, "tr");
    const struct phrase heads[] = {title, second, {"Points", "Puntos"}};
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
        html_open(page, "th");
        html_attribute(page, "scope", "col");
        if (i == 2)
            html_attribute(page, "class", "points");
        html_both(page, heads[i]);
        html_close(page, "th");
    }
    html_close(page, "tr");
    html_close(page, "thead");
    html_open(page, "tbody");
}

static void write_row_head(struct html *page, enum standing standing, struct phrase title)
{
    html_open(page, "tr");
    html_open(page, "th");
    html_attribute(page, "scope", "row");
    page_symbol(page, standing);
    html_text(page, " ");
    html_both(page, title);
    html_close(page, "th");
}

/* Why cases were not run, below the table of classes. */
static void write_not_run(struct html *page, const json_t *result)
{
    struct not_run not_run = result_not_run(result, NULL);
    if (not_run.count == 0)
        return;
    html_open(page, "p");
    html_attribute(page, "class", "quiet");
    html_both(page, not_run.reason);
    html_text(page, " ");
    html_both(page,
              (struct phrase){"Fix the problems below first; the remaining cases run after that.",
                              "Corrige primero los problemas de abajo; los demás casos se "
                              "ejecutarán después."});
    html_close(page, "p");
}

static void write_classes(struct html *page, const json_t *result)
{
    size_t i;
    json_t *part;
    html_open(page, "div");
    start_points_table(page, (struct phrase){"Class of input", "Clase de entrada"},
                       (struct phrase){"Cases", "Casos"});
    json_array_foreach(json_object_get(result, "classes"), i, part)
    {
        struct message tally;
        result_class_tally(result, part, &tally);
        write_row_head(page, result_class_standing(result, part), words_in(part, "title"));
        html_both_leaf(page, "td", NULL, message_phrase(&tally));
        write_points(page, result_number(part, "points"), result_number(part, "max_points"));
        html_close(page, "tr");
    }
    html_close(page, "tbody");
    html_close(page, "table");
    write_not_run(page, result);
    html_close(page, "div");
}

static void write_checks(struct html *page, const json_t *result)
{
    size_t i;
    json_t *part;
    if (json_array_size(json_object_get(result, "checks")) == 0)
        return;
    start_points_table(page, (struct phrase){"Check", "Comprobación"},
                       (struct phrase){"Outcome", "Resultado"});
    json_array_foreach(json_object_get(result, "checks"), i, part)
    {
        const char *verdict = result_text(part, "verdict");
        double points = result_number(part, "points");
        double max_points = result_number(part, "max_points");
        write_row_head(page, standing_of_points(points, max_points, verdict),
                       words_in(part, "title"));
        html_open(page, "td");
        html_both(page, words_verdict(verdict));
        if (*words_in(part, "message").en && words_standing(verdict) != STANDING_PASSED)
            html_both_leaf(page, "span", "message", words_in(part, "message"));
        html_close(page, "td");
        write_points(page, points, max_points);
        html_close(page, "tr");
    }
    html_close(page, "tbody");
    html_close(page, "table");
}

/* ---------------------------------------------------------------- the rest of an exercise */

static bool is_rejected(const json_t *one)
{
    enum standing standing = words_standing(result_text(one, "verdict"));
    return standing == STANDING_FAILED || standing == STANDING_UNSCORED;
}

/* Whether a rejected case stands open: the first with its cause, and the second, if it has a
 * picture. More of the same are behind a line to open. */
static bool is_open(const json_t *cases, size_t index)
{
    const json_t *one = json_array_get(cases, index);
    size_t same = 0;
    for (size_t i = 0; i < index; i++) {
        const json_t *earlier = json_array_get(cases, i);
        same += is_rejected(earlier) &&
                strcmp(result_text(earlier, "cause"), result_text(one, "cause")) == 0;
    }
    return same < (json_is_true(json_object_get(one, "scene")) ? 2 : 1);
}

/* Writes the rejected cases that are open, or those that are not; with page NULL only counts them.
 */
static size_t write_cases_that(bool open, struct html *page, const struct page_context *context,
                               const json_t *result)
{
    const json_t *cases = json_object_get(result, "cases");
    size_t count = 0;
    for (size_t i = 0; i < json_array_size(cases); i++) {
        if (!is_rejected(json_array_get(cases, i)) || is_open(cases, i) != open)
            continue;
        count++;
        if (page)
            page_case(page, context, result, json_array_get(cases, i));
    }
    return count;
}

static void write_cases(struct html *page, const struct page_context *context, const json_t *result)
{
    if (write_cases_that(true, NULL, context, result) == 0)
        return;
    html_both_leaf(page, "h3", NULL, (struct phrase){"What went wrong", "Qué ha fallado"});
    write_cases_that(true, page, context, result);
    size_t more = write_cases_that(false, NULL, context, result);
    if (more == 0)
        return;
    html_open(page, "details");
    html_attribute(page, "class", "more");
    html_open(page, "summary");
    html_format(page, "%zu ", more);
    html_both(page, more == 1 ? (struct phrase){"more rejected, for the same cause",
                                                "más rechazado, por la misma causa"}
                              : (struct phrase){"more rejected, for the same causes",
                                                "más rechazados, por las mismas causas"});
    html_close(page, "summary");
    write_cases_that(false, page, context, result);
    html_close(page, "details");
}

static void write_untrusted(struct html *page, const json_t *text, struct phrase title, bool open)
{
    if (json_string_length(text) == 0)
        return;
    html_open(page, "details");
    if (open)
        html_flag(page, "open");
    html_both_leaf(page, "summary", NULL, title);
    html_open(page, "pre");
    html_attribute(page, "tabindex", "0");
    html_json(page, text);
    html_close(page, "pre");
    html_close(page, "details");
}

static void write_files(struct html *page, const json_t *result)
{
    const json_t *files = json_object_get(json_object_get(result, "submission"), "files");
    size_t i;
    json_t *file;
    if (json_array_size(files) == 0)
        return;
    html_open(page, "details");
    html_both_leaf(page, "summary", NULL, (struct phrase){"Files graded", "Ficheros corregidos"});
    html_open(page, "ul");
    html_attribute(page, "class", "files");
    json_array_foreach(files, i, file)
    {
        html_open(page, "li");
        html_open(page, "code");
        html_json(page, json_object_get(file, "name"));
        html_close(page, "code");
        long long bytes = json_integer_value(json_object_get(file, "bytes"));
        html_format(page, " %lld byte%s, SHA-256 ", bytes, plural_ending(bytes));
        html_open(page, "code");
        html_json(page, json_object_get(file, "sha256"));
        html_close(page, "code");
        html_close(page, "li");
    }
    html_close(page, "ul");
    html_close(page, "details");
}

static void write_exercise(struct html *page, const struct page_context *context,
                           const json_t *result)
{
    const json_t *build = json_object_get(result, "build");
    html_open(page, "section");
    html_attribute(page, "class", "exercise");
    html_attribute(page, "id", result_text(result, "exercise"));
    html_open(page, "h2");
    html_leaf(page, "span", "problem", result_text(result, "problem"));
    html_text(page, " ");
    html_both(page, words_in(result, "title"));
    html_close(page, "h2");
    html_open(page, "p");
    html_attribute_format(page, "class", "sentence %s",
                          words_of_standing(result_standing(result)).en);
    page_score(page, result);
    html_text(page, " ");
    page_verdict(page, result_text(result, "verdict"));
    html_text(page, " ");
    html_both(page, words_in(result, "summary"));
    html_close(page, "p");
    write_untrusted(page, json_object_get(build, "diagnostics"),
                    (struct phrase){"What the compiler said", "Lo que dijo el compilador"},
                    json_is_false(json_object_get(build, "ok")));
    html_open(page, "div");
    html_attribute(page, "class", "two");
    write_classes(page, result);
    write_checks(page, result);
    html_close(page, "div");
    write_cases(page, context, result);
    page_quality(page, result);
    page_measures(page, result);
    write_untrusted(page, json_object_get(result, "output"),
                    (struct phrase){"What the program printed", "Lo que imprimió el programa"},
                    false);
    write_files(page, result);
    html_close(page, "section");
}

static bool has_scene(const struct student *student, size_t exercise_count)
{
    for (size_t e = 0; e < exercise_count; e++) {
        size_t i;
        json_t *one;
        json_array_foreach(json_object_get(student->results[e], "cases"), i, one)
        {
            if (json_is_true(json_object_get(one, "scene")))
                return true;
        }
    }
    return false;
}

static void write_heading(struct html *page, const struct page_context *context,
                          const struct gradebook *book, const struct student *student)
{
    char total[32];
    char max_total[32];
    char path[64];
    words_of_points(student->score, total, sizeof total);
    words_of_points(book->max_score, max_total, sizeof max_total);
    snprintf(path, sizeof path, "%sindex.html", context->up);
    html_open(page, "p");
    html_attribute(page, "class", "back");
    html_open(page, "a");
    html_path(page, "href", path);
    html_text(page, "← ");
    html_both(page, (struct phrase){"the class", "la clase"});
    html_close(page, "a");
    html_close(page, "p");
    html_open(page, "h1");
    html_open(page, "bdi");
    html_json(page, student->name);
    html_close(page, "bdi");
    html_close(page, "h1");
    html_open(page, "p");
    html_attribute(page, "class", "grand-total");
    html_leaf(page, "b", NULL, total);
    html_format(page, " / %s ", max_total);
    html_both(page, (struct phrase){"points", "puntos"});
    if (student->unscored > 0) {
        html_format(page, ", %d ", student->unscored);
        html_both(page, (struct phrase){"not scored yet", "aún sin nota"});
    }
    html_close(page, "p");
}

void page_student(struct html *page, const struct page_context *context,
                  const struct gradebook *book, const struct student *student)
{
    char stem[256], sheet[264];
    snprintf(stem, sizeof stem, "pictures/%s/sheet", student->folder);
    snprintf(sheet, sizeof sheet, "%s.png", stem);
    page_begin(page, context, "meshgrade: student", page_course(book),
               has_scene(student, book->exercise_count));
    write_heading(page, context, book, student);
    write_overview(page, book, student);
    page_pictures_note(page, context);
    for (size_t e = 0; e < book->exercise_count; e++)
        if (student->results[e])
            write_exercise(page, context, student->results[e]);
    if (page_has_file(context, sheet)) {
        html_both_leaf(page, "h2", NULL, (struct phrase){"All pictures", "Todas las imágenes"});
        page_picture(page, context, stem,
                     (struct phrase){"Contact sheet of the pictures above",
                                     "Hoja de contactos de las imágenes anteriores"});
    }
    html_open(page, "section");
    html_both_leaf(page, "h2", NULL, (struct phrase){"How it was graded", "Cómo se corrigió"});
    page_protections(page, student->results, book->exercise_count);
    html_close(page, "section");
    page_end(page, book);
}
