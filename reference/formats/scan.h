/* Reading text from memory, token by token and line by line, for the format readers.
 *
 * Lines end with LF, CR LF or CR. Numbers are read in the C locale whatever the program's locale
 * is. The bytes may be anything; nothing behind them is ever read. */
#ifndef REFERENCE_FORMATS_SCAN_H
#define REFERENCE_FORMATS_SCAN_H

#include "reference/base/error.h"

#include <locale.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct scan {
    const char *bytes;
    size_t byte_count;
    size_t at;        /* next byte to read */
    int64_t line;     /* its line, from 1 */
    const char *name; /* of the file, for errors */
    struct error *err;
    locale_t c_locale;
    bool is_binary;       /* errors name the byte, not the line */
    size_t item;          /* in binary data: first byte of what was read last, for errors */
    char comment;         /* starts a comment that ends with the line; 0: there are none */
    bool is_continued;    /* a backslash at the end of a line joins the next one to it */
    bool line_ends_by_cr; /* a CR alone ended the first line: an LF after it is data */
    size_t plain_end;     /* plain rows lie before it; see scan_plain.h */
};

struct token {
    const char *text; /* not terminated */
    size_t length;
};

/* Starts at the first byte (after a UTF-8 byte order mark). bytes may be NULL when byte_count is 0;
 * all pointers must outlive the scan, which the caller releases. Returns 0, or -1 and *err. */
int scan_init(struct scan *scan, const void *bytes, size_t byte_count, const char *name,
              struct error *err) MUST_CHECK;
void scan_release(struct scan *scan);

/* Next token of the current line: characters up to a blank, a comment or the end of the line.
 * Returns false at the end of the line, which it does not pass. */
bool scan_token(struct scan *scan, struct token *token);

/* Goes behind the end of the current line. */
void scan_end_line(struct scan *scan);

/* Goes to the next token, over blank and comment lines. Returns false at the end of the file. */
bool scan_find_token(struct scan *scan);

/* Bytes not yet read. */
size_t scan_left(const struct scan *scan);

/* Records an error at the present line (or byte), or at a given line: "name:12: ...". Returns -1.
 */
int scan_error(const struct scan *scan, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
int scan_error_at(const struct scan *scan, int64_t line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

bool scan_token_is(const struct token *token, const char *text);

/* The token made fit for a message: at most 40 characters, everything but printable ASCII as '?'.
 */
struct quoted {
    char text[48];
};
struct quoted scan_quote(const struct token *token);

/* Read a token as a number. `what` says what was expected, for the error: "the x of vertex 12".
 * Decimal only; what is too large for the type, NaN and infinity are errors. Return 0, or -1. */
int scan_integer(const struct scan *scan, const struct token *token, const char *what,
                 int64_t *value) MUST_CHECK;
int scan_float(const struct scan *scan, const struct token *token, const char *what,
               float *value) MUST_CHECK;
int scan_double(const struct scan *scan, const struct token *token, const char *what,
                double *value) MUST_CHECK;

/* The next token of the line as a number; that the line has one is checked too. Return 0, or -1. */
int scan_next_integer(struct scan *scan, const char *what, int64_t *value) MUST_CHECK;
int scan_next_float(struct scan *scan, const char *what, float *value) MUST_CHECK;

#endif
