/* Judging what a student says in numbers: formulas, asked at many parameters and right to the last
 * unit, single numbers, and the measured size of a structure against the student's own formula.
 *
 * A wrong formula is compared with the mistakes that are usual for it; when all the answers agree
 * with one of these, the student reads which. */
#ifndef GRADERS_LIBRARY_FORMULA_H
#define GRADERS_LIBRARY_FORMULA_H

#include "graders/library/judge.h"

/* A usual mistake: the value that it leads to. Hints are whole sentences. */
struct formula_mistake {
    struct cause cause; /* slug NULL ends a list */
    int64_t (*value)(int64_t a, int64_t b);
    struct phrase hint;
};

#define UNIT_VERTICES                                                                              \
    {                                                                                              \
        "vertices", "vértices"                                                                    \
    }

struct formula {
    const char *function;     /* "indexed_grid_bytes" */
    const char *parameter[2]; /* "m", "n"; the second is NULL when there is one parameter */
    struct phrase unit;       /* "bytes" */
    int64_t (*value)(int64_t a, int64_t b);
    const struct formula_mistake *mistakes; /* may be NULL */
};

/* Accepts when every answer is right. Otherwise rejects, names the first wrong row and shows the
 * submission's curve and the right one, over the first parameter (of the rows where both parameters
 * are equal) or, when all of these are right, over the right value.
 *
 * rows       2 * row_count parameters, the smallest first; the second of a row is 0 if there is one
 * answers    row_count values
 * returns    0, or -1 and *err (out of memory) */
int formula_judge(const struct formula *formula, const int32_t *rows, int64_t row_count,
                  const int64_t *answers, struct judgement *out, struct error *err) MUST_CHECK;

struct number_mistake {
    struct cause cause; /* slug NULL ends a list */
    double value;
    struct phrase hint;
};

struct number {
    const char *function; /* "indexed_grid_kilobytes" */
    double value;
    double tolerance;                      /* absolute */
    struct phrase rule;                    /* what was asked, without the value */
    const struct number_mistake *mistakes; /* may be NULL */
};

/* Half a unit of the second decimal (and a rounding error): whoever rounds to two decimals is
 * right. */
#define TWO_DECIMALS 0.005000001

/* Accepts a number within its tolerance; NaN never is. */
void formula_judge_number(const struct number *number, double answer, struct judgement *out);

/* The size of what a builder made.
 *
 *     builder, formula   names of the student's functions
 *     outside_bytes      bytes of the formula that do not lie on the heap: a count in the caller's
 *                        struct
 *     own_bytes          what the student's formula says
 *     right_bytes        what the structure takes */
struct size_claim {
    const char *builder, *formula;
    int64_t outside_bytes, own_bytes, right_bytes;
};

/* Accepts when the measured heap, the student's formula and the right size are one number. Without
 * a measurement only the formula is looked at. */
void formula_judge_size(const struct size_claim *claim, const struct usage *usage,
                        struct judgement *out);

#endif
