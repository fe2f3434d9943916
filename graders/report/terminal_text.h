/* Text laid out on a terminal: cleaned, cut and filled to columns. For terminal.c and its table. */
#ifndef GRADERS_REPORT_TERMINAL_TEXT_H
#define GRADERS_REPORT_TERMINAL_TEXT_H

#include "graders/report/terminal.h"
#include "graders/report/words.h"

#include <stddef.h>

enum { TERMINAL_COLUMNS = 80 };

/* Starts an standing's colour, and goes back to plain; nothing when the style has no colour. */
void terminal_colour(FILE *to, const struct terminal_style *style, enum standing standing);
void terminal_plain(FILE *to, const struct terminal_style *style);

/* One line: `start` (trusted) and `text`, cut with "..." to `columns`. Returns whether it was
 * whole. */
bool terminal_line(FILE *to, const char *start, const char *text, size_t columns);

/* Bytes of the first sentence of a text: up to a full stop before a blank, else all. */
size_t terminal_sentence(const char *text);

/* Text in exactly `columns`, cut with "..." or filled with blanks (before it, when `right`). */
void terminal_cell(FILE *to, const char *text, size_t columns, bool right);

/* Text broken at blanks to lines of TERMINAL_COLUMNS, each behind `margin`. */
void terminal_paragraph(FILE *to, const char *margin, const char *text);

/* The first `line_limit` lines of an untrusted string, each cut, each behind `margin`. */
void terminal_block(FILE *to, const char *margin, const json_t *text, size_t line_limit);

#endif
