/* Comparing sets of cyclic sequences: boundary loops, the corners of faces, rows of a table of
 * offsets and values. Rows stand in any order, and each may begin anywhere; direction counts.
 *
 *     struct cycle_rows answer = {first, vertices, loop_count, value_count};
 *     struct cycle_fault fault;
 *     if (cycles_compare(&answer, &right, &fault, err))
 *         return -1;
 *     if (fault.malformed >= 0)
 *         ... first[malformed] is wrong ...
 *     else if (set_fault_found(&fault.set))
 *         ... tell set_fault_cause(&fault.set), and fault.step where it is extra ...
 *     cycle_fault_release(&fault);
 */
#ifndef GRADERS_LIBRARY_CYCLES_H
#define GRADERS_LIBRARY_CYCLES_H

#include "graders/library/set_fault.h"

/* Rows of unequal length, borrowed. Row r is values[first[r]] ... values[first[r + 1] - 1]. */
struct cycle_rows {
    const int32_t *first; /* count + 1 offsets, which may hold anything; NULL when count is 0 */
    const int32_t *values;
    int64_t count;       /* rows; `first` really has count + 1 entries */
    int64_t value_count; /* numbers that `values` really has */
};

enum cycle_end {
    CYCLE_STEP_DIFFERS,   /* both go on, with different numbers */
    CYCLE_ANSWER_GOES_ON, /* the right row is complete there */
    CYCLE_ANSWER_ENDS,    /* the right row goes on */
    CYCLE_NOTHING_SHARED  /* the rows have no number in common */
};

/* Where the first extra row leaves the missing row that it resembles most. Cycles are followed from
 * the longest stretch that they have in common, sequences from their beginning. */
struct cycle_step {
    int64_t entry, right; /* the two rows; -1: no row is extra, or none is missing */
    int64_t place;        /* in the row of the answer: the first number that differs; the last one
                             with CYCLE_ANSWER_ENDS */
    bool has_before;      /* whether anything is the same up to there */
    int32_t before;       /* then the last number that is */
    int32_t found;        /* what the answer has next; not with CYCLE_ANSWER_ENDS */
    int32_t wanted;       /* what the right row has next; not with CYCLE_ANSWER_GOES_ON */
    enum cycle_end end;
};

struct cycle_fault {
    int64_t malformed; /* the first of the answer's offsets that is negative, below the one before
                          it or beyond value_count; -1: none. Then nothing else was looked at */
    struct set_fault set;
    struct cycle_step step;
};

/* Compares the rows of an answer with the right ones.
 *
 * right     well-formed; else an error
 * fault     on success the caller owns it (cycle_fault_release)
 * returns   0, or -1 and *err (out of memory, or counts below 0)
 * cost      O(n log n) for n numbers in all */
int cycles_compare(const struct cycle_rows *answer, const struct cycle_rows *right,
                   struct cycle_fault *fault, struct error *err) MUST_CHECK;

/* The same for rows that begin where they begin, as the fan of a vertex on the boundary. */
int sequences_compare(const struct cycle_rows *answer, const struct cycle_rows *right,
                      struct cycle_fault *fault, struct error *err) MUST_CHECK;

void cycle_fault_release(struct cycle_fault *fault);

/* Says where the two rows part, in a sentence: "After 4 comes 7; right is 9." No text when there is
 * no step. */
void cycle_step_say(const struct cycle_step *step, struct message *message);

/* -- single cycles ------------------------------------------------------------------------------
 */

/* Where the least rotation begins, in the order of numbers, the first such place; 0 when n is 0.
 * O(n). Source: folklore, two candidates that overtake each other. */
int64_t cyclic_least(const int32_t *row, int64_t n);

/* Turns a row in place so that it begins with its least rotation: rows are equal up to rotation
 * exactly when they are equal after that. Returns cyclic_least of the row as it was. */
int64_t cyclic_canonical(int32_t *row, int64_t n);

/* Turns a row round in place: its last number comes first. */
void cyclic_reverse(int32_t *row, int64_t n);

/* Whether two rows of n numbers are equal up to rotation. Then *shift (may be NULL) is one with
 * a[i] == b[(i + shift) % n]. O(n). */
bool cyclic_equal(const int32_t *a, const int32_t *b, int64_t n, int64_t *shift);

#endif
