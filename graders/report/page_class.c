/* The class page: marks, their distribution, causes, contact sheet, what staff must know. */
#include "graders/report/page.h"

#include "graders/report/results.h"

#include <stdlib.h>

static void write_number(struct html *page, const char *number, struct phrase label)
{
    html_open(page, "div");
    html_attribute(page, "class", "fact");
    html_leaf(page, "b", NULL, number);
    html_both_leaf(page, "span", NULL, label);
    html_close(page, "div");
}

/* The sum of the totals that are final, and how many those are. */
static double sum_of_totals(const struct gradebook *book, size_t *count)
{
    double sum = 0;
    *count = 0;
    for (size_t s = 0; s < book->student_count; s++) {
        if (book->students[s].unscored > 0)
            continue;
        sum += book->students[s].score;
        (*count)++;
    }
    return sum;
}

static void write_totals(struct html *page, const struct gradebook *book)
{
    size_t counts[STANDING_COUNT] = {0};
    size_t scored = 0;
    double sum = sum_of_totals(book, &scored);
    for (size_t s = 0; s < book->student_count; s++)
        for (size_t e = 0; e < book->exercise_count; e++)
            counts[result_standing(book->students[s].results[e])]++;
    char text[80];
    char points[32];
    char max_points[32];
    html_open(page, "div");
    html_attribute(page, "class", "facts-row");
    snprintf(text, sizeof text, "%zu", book->student_count);
    write_number(page, text,
                 book->student_count == 1 ? (struct phrase){"student", "estudiante"}
                                          : (struct phrase){"students", "estudiantes"});
    snprintf(text, sizeof text, "%zu", book->exercise_count);
    write_number(page, text,
                 book->exercise_count == 1 ? (struct phrase){"exercise", "ejercicio"}
                                           : (struct phrase){"exercises", "ejercicios"});
    if (scored > 0) {
        words_of_points(sum / (double)scored, points, sizeof points);
        words_of_points(book->max_score, max_points, sizeof max_points);
        snprintf(text, sizeof text, "%s / %s", points, max_points);
        write_number(page, text, (struct phrase){"mean total", "total medio"});
    }
    snprintf(text, sizeof text, "%zu", counts[STANDING_PASSED]);
    write_number(page, text,
                 (struct phrase){"answers with full marks", "respuestas con nota máxima"});
    if (counts[STANDING_UNSCORED] > 0) {
        snprintf(text, sizeof text, "%zu", counts[STANDING_UNSCORED]);
        write_number(page, text, (struct phrase){"wait for a person", "esperan a una persona"});
    }
    html_close(page, "div");
}

/* ---------------------------------------------------------------- distribution of marks */

enum { BIN_COUNT = 10, CHART_WIDTH = 560, CHART_HEIGHT = 190, BASE_LINE = 150, BAR_TOP = 24 };

static void write_bar(struct html *page, int bin, size_t students, size_t most)
{
    double slot = (double)CHART_WIDTH / BIN_COUNT;
    double height = (BASE_LINE - BAR_TOP) * (double)students / (double)most;
    html_open(page, "rect");
    html_attribute(page, "class", "bar");
    html_attribute_format(page, "x", "%.1f", slot * bin + 3);
    html_attribute_format(page, "y", "%.1f", BASE_LINE - height);
    html_attribute_format(page, "width", "%.1f", slot - 6);
    html_attribute_format(page, "height", "%.1f", height);
    html_attribute(page, "rx", "3");
    html_close(page, "rect");
    html_open(page, "text");
    html_attribute(page, "text-anchor", "middle");
    html_attribute_format(page, "x", "%.1f", slot * (bin + 0.5));
    html_attribute_format(page, "y", "%.1f", BASE_LINE - height - 6);
    if (students > 0)
        html_format(page, "%zu", students);
    html_close(page, "text");
    html_open(page, "text");
    html_attribute(page, "class", "tick");
    html_attribute(page, "text-anchor", "middle");
    html_attribute_format(page, "x", "%.1f", slot * (bin + 0.5));
    html_attribute_format(page, "y", "%d", BASE_LINE + 18);
    html_format(page, "%d–%d", bin * 100 / BIN_COUNT, (bin + 1) * 100 / BIN_COUNT);
    html_close(page, "text");
}

/* How many students have their total in each tenth of the maximum; unscored totals are left out. */
static void write_distribution(struct html *page, const struct gradebook *book)
{
    size_t bins[BIN_COUNT] = {0};
    size_t most = 1;
    size_t left_out = 0;
    for (size_t s = 0; s < book->student_count; s++) {
        if (book->students[s].unscored > 0 || book->max_score <= 0) {
            left_out++;
            continue;
        }
        int bin = (int)(BIN_COUNT * book->students[s].score / book->max_score + 1e-9);
        bins[bin < BIN_COUNT ? bin : BIN_COUNT - 1]++;
    }
    for (int i = 0; i < BIN_COUNT; i++)
        most = bins[i] > most ? bins[i] : most;

    html_both_leaf(page, "h2", NULL,
                   (struct phrase){"Distribution of totals", "Distribución de los totales"});
    html_open(page, "svg");
    html_attribute(page, "class", "chart distribution");
    html_attribute(page, "role", "img");
    html_attribute_format(page, "viewBox", "0 0 %d %d", CHART_WIDTH, CHART_HEIGHT);
    html_both_attribute(page, "aria-label",
                        (struct phrase){"Students by percent of the maximum total",
                                        "Estudiantes por porcentaje del total máximo"});
    html_open(page, "line");
    html_attribute(page, "class", "axis");
    html_attribute_format(page, "x2", "%d", CHART_WIDTH);
    html_attribute_format(page, "y1", "%d", BASE_LINE);
    html_attribute_format(page, "y2", "%d", BASE_LINE);
    html_close(page, "line");
    for (int i = 0; i < BIN_COUNT; i++)
        write_bar(page, i, bins[i], most);
    html_close(page, "svg");
    html_open(page, "p");
    html_attribute(page, "class", "quiet");
    html_both(page, (struct phrase){"Students by percent of the maximum total.",
                                    "Estudiantes por porcentaje del total máximo."});
    if (left_out > 0) {
        html_format(page, " %zu ", left_out);
        html_both(page, (struct phrase){"with answers that are not scored yet are left out.",
                                        "con respuestas aún sin nota no se cuentan."});
    }
    html_close(page, "p");
}

/* ---------------------------------------------------------------- the table of marks */

static void write_sort_header(struct html *page, const char *class_name)
{
    html_open(page, "th");
    html_attribute(page, "scope", "col");
    html_attribute(page, "class", class_name);
}

static void write_table_head(struct html *page, const struct gradebook *book)
{
    html_open(page, "thead");
    html_open(page, "tr");
    write_sort_header(page, "name");
    html_both(page, (struct phrase){"Student", "Estudiante"});
    html_close(page, "th");
    for (size_t e = 0; e < book->exercise_count; e++) {
        write_sort_header(page, "number");
        html_both_attribute(page, "title", book->exercises[e].title);
        html_leaf(page, "span", "problem", book->exercises[e].problem);
        html_leaf(page, "span", "exercise", book->exercises[e].name);
        html_close(page, "th");
    }
    write_sort_header(page, "number");
    html_both(page, (struct phrase){"Total", "Total"});
    html_close(page, "th");
    html_close(page, "tr");
    html_close(page, "thead");
}

static void write_cell(struct html *page, const struct student *student, const json_t *result,
                       const char *exercise)
{
    enum standing standing = result_standing(result);
    html_open(page, "td");
    html_attribute_format(page, "class", "cell %s", words_of_standing(standing).en);
    html_attribute_format(page, "data-value", "%.2f",
                          standing == STANDING_ABSENT     ? -2.0
                          : standing == STANDING_UNSCORED ? -1.0
                                                          : result_number(result, "score"));
    if (!result) {
        page_symbol(page, standing);
        html_close(page, "td");
        return;
    }
    char path[400];
    char score[32];
    snprintf(path, sizeof path, "students/%s.html#%s", student->folder, exercise);
    words_of_points(result_number(result, "score"), score, sizeof score);
    html_open(page, "a");
    html_path(page, "href", path);
    html_both_attribute(page, "title", words_verdict(result_text(result, "verdict")));
    page_symbol(page, standing);
    if (standing == STANDING_UNSCORED)
        html_both_leaf(page, "span", "word", words_verdict(result_text(result, "verdict")));
    else
        html_leaf(page, "span", "points", score);
    html_close(page, "a");
    html_close(page, "td");
}

static void write_row(struct html *page, const struct gradebook *book,
                      const struct student *student)
{
    char path[256];
    snprintf(path, sizeof path, "students/%s.html", student->folder);
    html_open(page, "tr");
    html_open(page, "th");
    html_attribute(page, "scope", "row");
    html_attribute(page, "class", "name");
    html_open(page, "a");
    html_path(page, "href", path);
    html_open(page, "bdi");
    html_json(page, student->name);
    html_close(page, "bdi");
    html_close(page, "a");
    html_close(page, "th");
    for (size_t e = 0; e < book->exercise_count; e++)
        write_cell(page, student, student->results[e], book->exercises[e].name);
    char total[32];
    words_of_points(student->score, total, sizeof total);
    html_open(page, "td");
    html_attribute(page, "class", "total");
    html_attribute_format(page, "data-value", "%.2f", student->score);
    html_leaf(page, "b", NULL, total);
    if (student->unscored > 0) {
        html_open(page, "span");
        html_both_attribute(
            page, "title",
            (struct phrase){"and answers that are not scored yet", "y respuestas aún sin nota"});
        html_text(page, " + ?");
        html_close(page, "span");
    }
    html_close(page, "td");
    html_close(page, "tr");
}

/* A mean beside its maximum; "–" of none. */
static void write_mean(struct html *page, double sum, size_t count, double max_score)
{
    char mean[32] = "–";
    char most[32];
    if (count > 0)
        words_of_points(sum / (double)count, mean, sizeof mean);
    words_of_points(max_score, most, sizeof most);
    html_open(page, "td");
    html_format(page, "%s ", mean);
    html_open(page, "span");
    html_attribute(page, "class", "quiet");
    html_format(page, "/ %s", most);
    html_close(page, "span");
    html_close(page, "td");
}

/* The row of means: of the answers that were scored, missing ones left out. */
static void write_means(struct html *page, const struct gradebook *book)
{
    html_open(page, "tfoot");
    html_open(page, "tr");
    html_open(page, "th");
    html_attribute(page, "scope", "row");
    html_attribute(page, "class", "name");
    html_both(page, (struct phrase){"Mean of those scored", "Media de las puntuadas"});
    html_close(page, "th");
    for (size_t e = 0; e < book->exercise_count; e++) {
        double sum = 0;
        size_t scored = 0;
        for (size_t s = 0; s < book->student_count; s++) {
            const json_t *result = book->students[s].results[e];
            if (json_is_number(json_object_get(result, "score"))) {
                sum += result_number(result, "score");
                scored++;
            }
        }
        write_mean(page, sum, scored, book->exercises[e].max_score);
    }
    size_t whole = 0;
    double total = sum_of_totals(book, &whole);
    write_mean(page, total, whole, book->max_score);
    html_close(page, "tr");
    html_close(page, "tfoot");
}

static void write_key(struct html *page)
{
    static const struct phrase meanings[STANDING_COUNT] = {
        [STANDING_PASSED] = {"full marks", "nota máxima"},
        [STANDING_PARTIAL] = {"some points", "algunos puntos"},
        [STANDING_FAILED] = {"no points", "ningún punto"},
        [STANDING_UNSCORED] = {"not scored: a person must look",
                               "sin nota: debe mirarlo una persona"},
        [STANDING_ABSENT] = {"nothing submitted", "no entregado"},
    };
    html_open(page, "p");
    html_attribute(page, "class", "key");
    for (int i = 0; i < STANDING_COUNT; i++) {
        html_open(page, "span");
        page_symbol(page, (enum standing)i);
        html_text(page, " ");
        html_both(page, meanings[i]);
        html_close(page, "span");
        html_text(page, " ");
    }
    html_close(page, "p");
}

static void write_marks(struct html *page, const struct gradebook *book)
{
    html_both_leaf(page, "h2", NULL, (struct phrase){"Marks", "Notas"});
    write_key(page);
    html_open(page, "div");
    html_attribute(page, "class", "scroll");
    html_attribute(page, "tabindex", "0");
    html_attribute(page, "role", "region");
    html_both_attribute(page, "aria-label", (struct phrase){"Table of marks", "Tabla de notas"});
    html_open(page, "table");
    html_attribute(page, "class", "marks sortable");
    write_table_head(page, book);
    html_open(page, "tbody");
    for (size_t s = 0; s < book->student_count; s++)
        write_row(page, book, &book->students[s]);
    html_close(page, "tbody");
    write_means(page, book);
    html_close(page, "table");
    html_close(page, "div");
}

/* ---------------------------------------------------------------- for staff */

static void write_unscored(struct html *page, const struct student *student, const json_t *result)
{
    char path[400];
    snprintf(path, sizeof path, "students/%s.html#%s", student->folder,
             result_text(result, "exercise"));
    html_open(page, "li");
    page_verdict(page, result_text(result, "verdict"));
    html_text(page, " ");
    html_open(page, "a");
    html_path(page, "href", path);
    html_open(page, "bdi");
    html_json(page, student->name);
    html_close(page, "bdi");
    html_format(page, ", %s", result_text(result, "exercise"));
    html_close(page, "a");
    html_text(page, ": ");
    html_both(page, words_in(result, "summary"));
    html_close(page, "li");
}

static void write_waiting(struct html *page, const struct gradebook *book)
{
    html_both_leaf(page, "h2", NULL,
                   (struct phrase){"Waiting for a person", "Pendiente de una persona"});
    bool any = false;
    html_open(page, "ul");
    html_attribute(page, "class", "staff");
    for (size_t s = 0; s < book->student_count; s++) {
        for (size_t e = 0; e < book->exercise_count; e++) {
            const json_t *result = book->students[s].results[e];
            if (result_standing(result) != STANDING_UNSCORED)
                continue;
            write_unscored(page, &book->students[s], result);
            any = true;
        }
    }
    if (!any)
        html_both_leaf(page, "li", "quiet",
                       (struct phrase){"Nothing: every answer was scored.",
                                       "Nada: todas las respuestas tienen nota."});
    html_close(page, "ul");
}

static void write_protections(struct html *page, const struct gradebook *book)
{
    size_t count = json_array_size(book->all);
    json_t **all = calloc(count + 1, sizeof(json_t *));
    if (!all) {
        page->fault = "out of memory";
        return;
    }
    for (size_t i = 0; i < count; i++)
        all[i] = json_array_get(book->all, i);
    page_protections(page, all, count);
    free(all);
}

static void write_sheet(struct html *page, const struct page_context *context)
{
    page_pictures_note(page, context);
    if (!page_has_file(context, "pictures/class.png"))
        return;
    html_both_leaf(page, "h2", NULL,
                   (struct phrase){"What went wrong, in pictures", "Qué falló, en imágenes"});
    page_picture(page, context, "pictures/class",
                 (struct phrase){"Contact sheet: one picture for each frequent cause",
                                 "Hoja de contactos: una imagen por cada causa frecuente"});
}

void page_class(struct html *page, const struct page_context *context, const struct gradebook *book)
{
    page_begin(page, context, "meshgrade: class", page_course(book), false);
    html_both_leaf(page, "h1", NULL,
                   (struct phrase){"Results of the class", "Resultados de la clase"});
    write_totals(page, book);
    write_marks(page, book);
    html_open(page, "div");
    html_attribute(page, "class", "two");
    html_open(page, "section");
    write_distribution(page, book);
    html_close(page, "section");
    html_open(page, "section");
    write_waiting(page, book);
    html_close(page, "section");
    html_close(page, "div");
    page_causes(page, book);
    write_sheet(page, context);
    html_both_leaf(page, "h2", NULL, (struct phrase){"How it was graded", "Cómo se corrigió"});
    write_protections(page, book);
    page_tools(page, book);
    page_end(page, book);
}
