/* Reading text from memory, token by token and line by line, for the format readers.
 *
 * Lines end with LF, CR LF or CR; also with LF CR or CR CR LF where the first line does. Numbers are read in the C locale whatever the program's locale
 * is. The bytes may be anything; nothing behind them is ever read. */
#ifndef REFERENCE_FORMATS_SCAN_H
#define REFERENCE_FORMATS_SCAN_H

#include "reference/base/error.h"
#include "reference/formats/reading.h"

#include <locale.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum line_end { LINE_END_LF, LINE_END_CR, LINE_END_CR_LF, LINE_END_LF_CR, LINE_END_CR_CR_LF };

struct scan {
    const char *bytes;
    size_t byte_count;
    size_t at;        /* next byte to read */
    int64_t line;     /* its line, from 1 */
    const char *name; /* of the file, for errors */
    struct error *err;
    locale_t c_locale;
    bool is_binary;         /* errors name the byte, not the line */
    size_t item;            /* in binary data: first byte of what was read last, for errors */
    char comment;           /* starts a comment that ends with the line; 0: there are none */
    bool is_continued;      /* a backslash at the end of a line joins the next one to it */
    bool holds_a_name;      /* of this line: a backslash at the end of a name belongs to the name */
    enum line_end line_end; /* of the first line; what is more than that is data */
    size_t plain_end;       /* plain rows lie before it; see scan_plain.h */
    struct reading *reading; /* of what is left out; NULL: that is an error. Set by the reader */
    bool is_broken;          /* the present row goes on in another line; see scan_row_goes_on */
    int64_t broken_line;
    char broken[96];
};

struct token {
    const char *text; /* not terminated */
    size_t length;
};

/* Starts at the first byte (after a UTF-8 byte order mark). bytes may be NULL when byte_count is 0;
 * all pointers must outlive the scan, which the caller releases. Returns 0, or -1 and *err (out of
 * memory, or text in UTF-16 or UTF-32). */
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

/* -- rows that are broken over lines -------------------------------------------------------------
 *
 * A row whose line ends too early goes on in the next line that holds something, so long as it ends
 * with a line: what else looks like that is a value that was forgotten. */

/* Where a row begins. */
void scan_begin_row(struct scan *scan);

/* Takes the next token from a later line, since this line has none. The format says what is missing
 * if that was wrong: "the y is missing: vertex 3 ends before it". Returns 0, or -1 and that error
 * when the file ends. */
int scan_row_goes_on(struct scan *scan, struct token *token, const char *format, ...) MUST_CHECK
    __attribute__((format(printf, 3, 4)));

/* The row should end here and does not: returns -1 after recording what is missing where the row was
 * broken, if it was, and else the given error. */
int scan_row_error(struct scan *scan, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* -- what is left out --------------------------------------------------------------------------- */

/* Notes in the reading, which must be there, that `count` things of a kind are left out, of which
 * the first stands here, or at `place`. */
void scan_note(const struct scan *scan, enum reading_kind kind, int64_t count);
void scan_note_at(const struct scan *scan, enum reading_kind kind, int64_t count, int64_t place);

/* The present line, in binary data the byte of what was read last. */
int64_t scan_place(const struct scan *scan);

/* Whether a token begins with a UTF-8 byte order mark, as in files that were joined. */
bool scan_token_is_marked(const struct token *token);

/* Records an error at the present line (or byte), or at a given one: "name:12: ...". Returns -1.
 */
int scan_error(const struct scan *scan, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
int scan_error_at(const struct scan *scan, int64_t place, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

bool scan_token_is(const struct token *token, const char *text);

/* The token made fit for a message: at most 40 characters, everything but printable ASCII as '?'.
 */
struct quoted {
    char text[48];
};
struct quoted scan_quote(const struct token *token);

/* Read a token as a number. `what` says what was expected, for the error: "the x of vertex 12".
 * Decimal only; what is too large for the type, NaN and infinity are errors, but with a reading NaN
 * and infinity are read, both as NaN. Return 0, or -1. */
int scan_integer(const struct scan *scan, const struct token *token, const char *what,
                 int64_t *value) MUST_CHECK;
int scan_float(const struct scan *scan, const struct token *token, const char *what,
               float *value) MUST_CHECK;
int scan_double(const struct scan *scan, const struct token *token, const char *what,
                double *value) MUST_CHECK;

/* The next token of the line as a number; that the line has one is checked too. Return 0, or -1.
 * The row ones go on in later lines. */
int scan_next_integer(struct scan *scan, const char *what, int64_t *value) MUST_CHECK;
int scan_next_float(struct scan *scan, const char *what, float *value) MUST_CHECK;
int scan_row_integer(struct scan *scan, const char *what, int64_t *value) MUST_CHECK;
int scan_row_float(struct scan *scan, const char *what, float *value) MUST_CHECK;

#endif
