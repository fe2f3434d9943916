/* What is wrong with an answer that is a set of rows, and how rows are matched: the common half of
 * tuples.h and cycles.h.
 *
 * An entry is a row of the answer. The sets are multisets: what is right twice must be listed
 * twice.
 *
 *     missing    a row of the right table that the answer lacks, or lists too seldom
 *     extra      an entry that is no row of the right table
 *     repeated   an entry that is right, but listed more often than the right table has it
 *     reversed   an entry that is no right row, but would be a missing one if read backwards; then
 *                the two are neither extra nor missing */
#ifndef GRADERS_LIBRARY_SET_FAULT_H
#define GRADERS_LIBRARY_SET_FAULT_H

#include "reference/base/error.h"
#include "reference/base/phrase.h"

#include <stdbool.h>
#include <stdint.h>

/* The mark of an entry, and of a right row. */
enum set_mark { SET_FINE, SET_MISSING, SET_EXTRA, SET_REPEATED, SET_REVERSED };

/* The first element of each kind by its place in its table (-1: none), and how many there are. */
struct set_fault {
    int64_t missing, missing_count; /* a row of the right table */
    int64_t extra, extra_count;     /* an entry */
    int64_t repeated, repeated_of;  /* an entry, and the first entry equal to it */
    int64_t repeated_count;
    int64_t reversed, reversed_right; /* an entry, and the right row that it reverses */
    int64_t reversed_count;
    uint8_t *entry_marks; /* enum set_mark of every entry: fine, extra, repeated or reversed */
    uint8_t *right_marks; /* of every right row: fine, missing or reversed */
};

extern const struct cause set_missing, set_extra, set_repeated, set_reversed;

/* Whether anything is wrong. */
bool set_fault_found(const struct set_fault *fault);

/* The cause to tell first: repeated, extra, reversed, missing, in this order; NULL: nothing is
 * wrong. So a set without the first three that has the right count misses nothing. */
const struct cause *set_fault_cause(const struct set_fault *fault);

/* Frees the marks. The zero value may be released, and releasing twice does no harm. */
void set_fault_release(struct set_fault *fault);

/* -- for comparisons of other kinds of rows ----------------------------------------------------
 *
 * Rows as they are compared: brought into one form, so that rows that count as equal have equal
 * numbers. The rows of the answer come first, then those of the right table. */
struct set_rows {
    int32_t *values;
    int64_t *first; /* row i: values[first[i]] ... values[first[i + 1] - 1] */
    int64_t entry_count, right_count;
};

/* Makes room for rows; the caller fills values and first, and owns them (set_rows_release).
 * Returns 0, or -1 and *err (out of memory, or a negative count). */
int set_rows_init(struct set_rows *rows, int64_t entry_count, int64_t right_count,
                  int64_t value_count, struct error *err) MUST_CHECK;
void set_rows_release(struct set_rows *rows);

/* Matches entries with right rows; O(n log n) for n numbers in all.
 *
 * turn      makes of a row the form of its reverse; NULL: reversed rows are not looked for. The
 *           rows at fault are changed by it
 * fault     on success the caller owns it (set_fault_release)
 * returns   0, or -1 and *err (out of memory) */
int set_rows_match(struct set_rows *rows, void (*turn)(int32_t *row, int64_t length),
                   struct set_fault *fault, struct error *err) MUST_CHECK;

#endif
