/* Makes text from outside (names, program output, compiler diagnostics) safe to show anywhere: on a
 * terminal, in HTML, XML, CSV, JSON. What could act is made visible instead:
 *
 *     control characters      \x1b      (as C writes them; so no escape sequence survives)
 *     bytes that are not UTF-8 \xff
 *     bidi overrides, invisible and forbidden characters   <U+202E>      (as gcc writes them)
 *
 * What comes out is always valid UTF-8, and every character of it is allowed in XML 1.0. Markup is
 * not touched: each writer (html.h, the exporters) escapes for its own format. */
#ifndef GRADERS_REPORT_CLEAN_H
#define GRADERS_REPORT_CLEAN_H

#include <stddef.h>

enum clean_form {
    CLEAN_LINE, /* one line: newlines and tabs are control characters like the others */
    CLEAN_BLOCK /* newline and tab stay; carriage return before a newline is dropped */
};

/* The cleaned text, in memory that the caller frees.
 *
 * text, length  any bytes (may hold NUL); text may be NULL when length is 0
 * limit_bytes   of a longer text only the first limit_bytes are used (cut before a character that
 *               would not fit whole) and " [... N bytes more]" is added
 * returns       NULL when out of memory; never longer than 4 * limit_bytes + 40 bytes */
char *clean_text(const char *text, size_t length, enum clean_form form, size_t limit_bytes);

/* Terminal columns that a cleaned text takes: 0 for a combining mark, 2 for a wide East Asian
 * character, 1 for every other. For one line of text. */
size_t clean_columns(const char *text);

/* Bytes of the longest prefix of a cleaned text that fits in `columns`, whole characters only. */
size_t clean_prefix(const char *text, size_t columns);

#endif
