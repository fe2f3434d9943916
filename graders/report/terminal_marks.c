/* The table of marks on a terminal; see terminal.h. Exercises that do not fit side by side in 80
 * columns stand in blocks below each other, each with every student; the last one has the totals.
 */
#include "graders/report/clean.h"
#include "graders/report/results.h"
#include "graders/report/terminal_text.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum {
    NAME_COLUMNS = 20,
    TOTAL_COLUMNS = 10,
    LEAST_COLUMNS = 6, /* "✓ 8.25" */
    MOST_COLUMNS = 16,
    NAMED_COLUMNS = 12, /* from here on a column shows its exercise's name */
    ROOM_COLUMNS = TERMINAL_COLUMNS - NAME_COLUMNS - TOTAL_COLUMNS - 1,
    BLOCK_MOST = ROOM_COLUMNS / (LEAST_COLUMNS + 1)
};

/* Exercises first ... end - 1 of the gradebook, side by side. */
struct block {
    size_t first, end, width;
    bool has_total;
};

/* As few blocks as there can be, of about the same number of exercises. */
static size_t count_blocks(const struct gradebook *book)
{
    size_t blocks = (book->exercise_count + BLOCK_MOST - 1) / BLOCK_MOST;
    return blocks > 0 ? blocks : 1;
}

static struct block choose_block(const struct gradebook *book, size_t index)
{
    size_t blocks = count_blocks(book);
    size_t most = (book->exercise_count + blocks - 1) / blocks;
    size_t width = most > 0 ? ROOM_COLUMNS / most - 1 : 0;
    return (struct block){.first = book->exercise_count * index / blocks,
                          .end = book->exercise_count * (index + 1) / blocks,
                          .width = width > MOST_COLUMNS ? MOST_COLUMNS : width,
                          .has_total = index + 1 == blocks};
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

/* What stands above a narrow column: the problem's number, or "#3" for the third exercise, which
 * the key below the table explains. */
static const char *short_name(const struct gradebook *book, size_t exercise, char *text,
                              size_t capacity)
{
    if (*short_problem(book->exercises[exercise].problem, text, capacity) == '\0')
        snprintf(text, capacity, "#%zu", exercise + 1);
    return text;
}

/* The header: short names, and where there is room the names below them. */
static void put_header(FILE *to, const struct gradebook *book, const struct block *block,
                       enum language language)
{
    const char *student = phrase_text((struct phrase){"student", "estudiante"}, language);
    bool named = block->width >= NAMED_COLUMNS;
    char text[32];
    if (named) {
        terminal_cell(to, "", NAME_COLUMNS, false);
        for (size_t e = block->first; e < block->end; e++) {
            fputc(' ', to);
            terminal_cell(to, short_problem(book->exercises[e].problem, text, sizeof text),
                          block->width, true);
        }
        fputc('\n', to);
    }
    terminal_cell(to, student, NAME_COLUMNS, false);
    for (size_t e = block->first; e < block->end; e++) {
        fputc(' ', to);
        terminal_cell(to, named ? book->exercises[e].name : short_name(book, e, text, sizeof text),
                      block->width, true);
    }
    if (block->has_total) {
        fputc(' ', to);
        terminal_cell(to, "total", TOTAL_COLUMNS, true);
    }
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

static void put_student(FILE *to, const struct student *student, const struct block *block,
                        const struct terminal_style *style)
{
    char *name = clean_text(json_string_value(student->name), json_string_length(student->name),
                            CLEAN_LINE, 200);
    char total[64];
    char points[32];
    terminal_cell(to, name ? name : student->folder, NAME_COLUMNS, false);
    for (size_t e = block->first; e < block->end; e++)
        put_mark(to, student->results[e], block->width, style);
    if (block->has_total) {
        words_of_points(student->score, points, sizeof points);
        snprintf(total, sizeof total, "%s%s", points, student->unscored > 0 ? " + ?" : "");
        fputc(' ', to);
        terminal_cell(to, total, TOTAL_COLUMNS, true);
    }
    fputc('\n', to);
    free(name);
}

/* What the columns "#3" are, as many a line as fit. */
static void put_names(FILE *to, const struct gradebook *book)
{
    size_t column = 0;
    for (size_t e = 0; e < book->exercise_count; e++) {
        char text[128];
        snprintf(text, sizeof text, "#%zu %s", e + 1, book->exercises[e].name);
        size_t columns = clean_columns(text);
        if (*book->exercises[e].problem)
            continue;
        bool fits = column > 0 && column + 2 + columns <= TERMINAL_COLUMNS;
        fprintf(to, "%s%s", fits ? "  " : "\n", text);
        column = columns + (fits ? column + 2 : 0);
    }
    fputs(column > 0 ? "\n" : "", to);
}

static void put_key(FILE *to, const struct gradebook *book, enum language language)
{
    char points[32];
    words_of_points(book->max_score, points, sizeof points);
    struct message key;
    message_say(&key,
                "maximum %s. ✓ full marks  ◐ some points  ✗ none\n"
                "! a person must look  – nothing submitted\n",
                "máximo %s. ✓ nota máxima  ◐ algunos puntos  ✗ ninguno\n"
                "! debe mirarlo una persona  – no entregado\n",
                points);
    fprintf(to, "\n%s", message_text(&key, language));
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
    size_t blocks = count_blocks(&book);
    for (size_t i = 0; i < blocks; i++) {
        struct block block = choose_block(&book, i);
        fputs(i > 0 ? "\n" : "", to);
        put_header(to, &book, &block, style->language);
        for (size_t s = 0; s < book.student_count; s++)
            put_student(to, &book.students[s], &block, style);
    }
    if (choose_block(&book, 0).width < NAMED_COLUMNS)
        put_names(to, &book);
    put_key(to, &book, style->language);
    gradebook_release(&book);
}
