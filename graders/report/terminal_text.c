/* Laying out text on a terminal; see terminal_text.h. */
#include "graders/report/terminal_text.h"

#include "graders/report/clean.h"

#include <stdlib.h>
#include <string.h>

enum { TEXT_LIMIT_BYTES = 2000 };

void terminal_colour(FILE *to, const struct terminal_style *style, enum standing standing)
{
    static const char *const codes[STANDING_COUNT] = {
        [STANDING_PASSED] = "\033[32m",   [STANDING_PARTIAL] = "\033[33m",
        [STANDING_FAILED] = "\033[1;31m", [STANDING_UNSCORED] = "\033[35m",
        [STANDING_ABSENT] = "\033[2m",
    };
    if (style->colour)
        fputs(codes[standing], to);
}

void terminal_plain(FILE *to, const struct terminal_style *style)
{
    if (style->colour)
        fputs("\033[0m", to);
}

static char *cleaned(const char *text)
{
    return clean_text(text, strlen(text), CLEAN_LINE, TEXT_LIMIT_BYTES);
}

/* Writes what fits of a cleaned text; returns the columns taken. */
static size_t put_cut(FILE *to, const char *text, size_t columns, bool *whole)
{
    static const char dots[] = "...";
    size_t width = clean_columns(text);
    *whole = width <= columns;
    if (*whole) {
        fputs(text, to);
        return width;
    }
    size_t room = columns > strlen(dots) ? columns - strlen(dots) : 0;
    size_t bytes = clean_prefix(text, room);
    while (bytes > 0 && text[bytes - 1] == ' ')
        bytes--;
    fprintf(to, "%.*s%s", (int)bytes, text, dots);
    char *kept = strndup(text, bytes);
    size_t taken = (kept ? clean_columns(kept) : bytes) + strlen(dots);
    free(kept);
    return taken;
}

bool terminal_line(FILE *to, const char *start, const char *text, size_t columns)
{
    bool whole = false;
    char *clean = cleaned(text);
    size_t used = clean_columns(start);
    fputs(start, to);
    if (clean)
        put_cut(to, clean, columns > used ? columns - used : 0, &whole);
    fputc('\n', to);
    free(clean);
    return whole;
}

size_t terminal_sentence(const char *text)
{
    const char *end = strstr(text, ". ");
    return end ? (size_t)(end + 1 - text) : strlen(text);
}

void terminal_cell(FILE *to, const char *text, size_t columns, bool right)
{
    bool whole = false;
    char *clean = cleaned(text);
    size_t width = clean ? clean_columns(clean) : 0;
    if (right && width < columns)
        fprintf(to, "%*s", (int)(columns - width), "");
    size_t taken = clean ? put_cut(to, clean, columns, &whole) : 0;
    if (!right && taken < columns)
        fprintf(to, "%*s", (int)(columns - taken), "");
    free(clean);
}

void terminal_paragraph(FILE *to, const char *margin, const char *text)
{
    char *clean = cleaned(text);
    size_t room = TERMINAL_COLUMNS - clean_columns(margin);
    for (char *at = clean; at && *at;) {
        size_t bytes = clean_prefix(at, room);
        size_t end = bytes;
        if (at[bytes] != '\0') {
            while (end > 0 && at[end] != ' ')
                end--;
            end = end > 0 ? end : bytes; /* a word longer than the line is cut */
        }
        fprintf(to, "%s%.*s\n", margin, (int)end, at);
        at += end;
        at += strspn(at, " ");
    }
    free(clean);
}

void terminal_block(FILE *to, const char *margin, const json_t *text, size_t line_limit)
{
    enum { BLOCK_LIMIT_BYTES = 20000 };
    char *clean = clean_text(json_string_value(text), json_string_length(text), CLEAN_BLOCK,
                             BLOCK_LIMIT_BYTES);
    char *rest = clean;
    for (size_t i = 0; rest && *rest && i < line_limit; i++) {
        char *line = strsep(&rest, "\n");
        terminal_line(to, margin, line, TERMINAL_COLUMNS);
    }
    if (rest && *rest)
        fprintf(to, "%s...\n", margin);
    free(clean);
}
