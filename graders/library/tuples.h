/* Comparing sets of tuples: tables of edges, pairs, triangles, or of single numbers (width 1).
 * Entries stand in any order; within an entry the symmetry says what counts as the same.
 *
 *     struct set_fault fault;
 *     if (tuples_compare(edges, edge_count, right, right_count, 2, TUPLES_ANY_ORDER, &fault, err))
 *         return -1;
 *     const struct cause *cause = set_fault_cause(&fault);
 *     if (cause == &set_repeated)
 *         ... entry fault.repeated repeats entry fault.repeated_of ...
 *     set_fault_release(&fault);
 */
#ifndef GRADERS_LIBRARY_TUPLES_H
#define GRADERS_LIBRARY_TUPLES_H

#include "graders/library/set_fault.h"

enum { TUPLE_WIDTH_MOST = 32 };

enum tuple_symmetry {
    TUPLES_EXACT,    /* (1,2,3) is only (1,2,3) */
    TUPLES_REVERSED, /* ... or (3,2,1): paths without a direction */
    TUPLES_ROTATED,  /* ... or (2,3,1) or (3,1,2): oriented faces */
    TUPLES_ANY_ORDER /* all six: sets of vertices; edges, for width 2 */
};

/* Compares the table of an answer with the right one. Numbers may be anything: no bound is needed.
 * Entries that are right but for their direction are told apart as `reversed` when direction counts
 * (TUPLES_EXACT, TUPLES_ROTATED).
 *
 * answer, right   rows of `width` numbers; may be NULL when their count is 0. The counts are those
 *                 of tables that are really there: check what an answer claims before
 * width           1 ... TUPLE_WIDTH_MOST
 * fault           on success the caller owns it (set_fault_release)
 * returns         0, or -1 and *err (out of memory, or an argument out of its range)
 * cost            O(n log n) */
int tuples_compare(const int32_t *answer, int64_t answer_count, const int32_t *right,
                   int64_t right_count, int width, enum tuple_symmetry symmetry,
                   struct set_fault *fault, struct error *err) MUST_CHECK;

#endif
