/* The table of marks on a terminal; see terminal.h. Where the exercises do not fit side by side in
 * 80 columns their names are cut; from eleven exercises on the line is longer than that. */
#include "graders/report/clean.h"
#include "graders/report/results.h"
#include "graders/report/terminal_text.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { NAME_COLUMNS = 20, TOTAL_COLUMNS = 8, LEAST_COLUMNS = 5, MOST_COLUMNS = 16 };

static size_t column_width(const struct gradebook *book)
{
    size_t room = TERMINAL_COLUMNS - NAME_COLUMNS - TOTAL_COLUMNS - 1;
    size_t width = book->exercise_count ? room / book->exercise_count : room;
    width = width > 0 ? width - 1 : 0;
    return width < LEAST_COLUMNS ? LEAST_COLUMNS : width > MOST_COLUMNS ? MOST_COLUMNS : width;
}

/* "4.5 (a)" as "4.5a": problem numbers stand in narrow columns. */
static const char *short_problem(const char *problem, char *text, size_t capacity)
{
    size_t count = 0;
    for (; *problem && count + 1 < capacity; problem++)
        if (*problem != ' ' && *problem != '(' && *problem != ')')
            text[count++] = *problem;
    text[count] = '\0';
    return text;
}

/* The header: problem numbers, which are short, and below them as much of the names as fits. */
static void put_header(FILE *to, const struct gradebook *book, size_t width, bool spanish)
{
    terminal_cell(to, "", NAME_COLUMNS, false);
    for (size_t e = 0; e < book->exercise_count; e++) {
        char problem[32];
        fputc(' ', to);
        terminal_cell(to, short_problem(book->exercises[e].problem, problem, sizeof problem), width,
                      true);
    }
    fputc('\n', to);
    terminal_cell(to, spanish ? "estudiante" : "student", NAME_COLUMNS, false);
    for (size_t e = 0; e < book->exercise_count; e++) {
        fputc(' ', to);
        terminal_cell(to, width >= 12 ? book->exercises[e].name : "", width, true);
    }
    fputc(' ', to);
    terminal_cell(to, "total", TOTAL_COLUMNS, true);
    fputc('\n', to);
}

static void put_mark(FILE *to, const json_t *result, size_t width,
                     const struct terminal_style *style)
{
    enum standing standing = result_standing(result);
    char mark[64];
    char points[32];
    words_of_points(result_number(result, "score"), points, sizeof points);
    bool has_points = standing != STANDING_UNSCORED && standing != STANDING_ABSENT;
    snprintf(mark, sizeof mark, "%s%s%s", words_symbol(standing), has_points ? " " : "",
             has_points ? points : "");
    fputc(' ', to);
    terminal_colour(to, style, standing);
    terminal_cell(to, mark, width, true);
    terminal_plain(to, style);
}

static void put_student(FILE *to, const struct gradebook *book, const struct student *student,
                        size_t width, const struct terminal_style *style)
{
    char *name = clean_text(json_string_value(student->name), json_string_length(student->name),
                            CLEAN_LINE, 200);
    char total[64];
    char points[32];
    terminal_cell(to, name ? name : student->folder, NAME_COLUMNS, false);
    for (size_t e = 0; e < book->exercise_count; e++)
        put_mark(to, student->results[e], width, style);
    words_of_points(student->score, points, sizeof points);
    snprintf(total, sizeof total, "%s%s", points, student->unscored > 0 ? " + ?" : "");
    fputc(' ', to);
    terminal_cell(to, total, TOTAL_COLUMNS, true);
    fputc('\n', to);
    free(name);
}

static void put_key(FILE *to, const struct gradebook *book, bool spanish)
{
    char points[32];
    words_of_points(book->max_score, points, sizeof points);
    if (spanish)
        fprintf(to,
                "\nmáximo %s. ✓ nota máxima  ◐ algunos puntos  ✗ ninguno  ! debe mirarlo una "
                "persona\n– no entregado\n",
                points);
    else
        fprintf(to,
                "\nmaximum %s. ✓ full marks  ◐ some points  ✗ none  ! a person must look\n"
                "– nothing submitted\n",
                points);
}

void terminal_print_marks(FILE *to, const json_t *results, const struct terminal_style *style)
{
    struct gradebook book;
    struct error err = {""};
    /* The gradebook only counts references to the results. */
    if (gradebook_from((json_t *)(uintptr_t)results, &book, &err) != 0) {
        fprintf(to, "%s\n", err.text);
        return;
    }
    size_t width = column_width(&book);
    put_header(to, &book, width, style->spanish);
    for (size_t s = 0; s < book.student_count; s++)
        put_student(to, &book, &book.students[s], width, style);
    put_key(to, &book, style->spanish);
    gradebook_release(&book);
}
