/* Plain rows: the lines that nearly every file consists of, read several times faster than token by
 * token. A plain row holds only numbers of the common forms (number.h), blanks (space, tab), and
 * ends with LF or CR LF; no comment, no continuation, not the last line.
 *
 * Each function reads at scan->at, changes nothing in the scan, and returns the place behind the
 * row, for scan_pass_row; or NULL when the row is not plain, wrong or unusual: then it is read
 * token by token, which gives the same values and names what is wrong. */
#ifndef REFERENCE_FORMATS_SCAN_PLAIN_H
#define REFERENCE_FORMATS_SCAN_PLAIN_H

#include "reference/formats/scan.h"

enum { PLAIN_LIMIT = 16 }; /* numbers in a plain row */

struct scan_plain_floats {
    float values[PLAIN_LIMIT];
    int count;
};

struct scan_plain_integers {
    int64_t values[PLAIN_LIMIT];
    int count;
};

/* The numbers of a row, after `skipped` characters of it; scan->at < scan->plain_end must hold for
 * those too (a keyword's own bytes, which the caller has looked at). */
const char *scan_plain_floats(const struct scan *scan, size_t skipped,
                              struct scan_plain_floats *row);
const char *scan_plain_integers(const struct scan *scan, size_t skipped,
                                struct scan_plain_integers *row);

/* As scan_plain_integers, for the corners of a face in OBJ: behind each number may follow a slash and a
 * whole number or none, once or twice, which are passed over. */
const char *scan_plain_corners(const struct scan *scan, size_t skipped,
                               struct scan_plain_integers *row);

/* Whether a plain row may start here and at least `count` bytes stand in front of its end. */
static inline bool may_be_plain(const struct scan *scan, size_t count)
{
    return scan->at + count <= scan->plain_end;
}

/* Goes behind a plain row. */
static inline void scan_pass_row(struct scan *scan, const char *behind)
{
    scan->at = (size_t)(behind - scan->bytes);
    scan->line++;
}

#endif
