/* How counted work grows with the size of the input.
 *
 * The counts of instructions at sizes n, 2n, 4n, ... are fitted by a mixture with coefficients >= 0
 *
 *     c0 + c1 n + c2 n lg n + c3 n^1.5 + c4 n^2 (+ c5 n^3 when n^2 is allowed)
 *
 * least squares of the *relative* residuals, so that small sizes weigh as much as large ones. The
 * share of each term of the work at the largest size then says what grows: one best-fitting class
 * would call "sort, then a scan over 1/64 of all pairs" n lg n; the mixture shows its n^2 term.
 *
 * The allowed class is an upper bound. n and n lg n count as one class: over a few doublings they
 * differ by less than honest algorithms do (cache-friendly hashing, early exits).
 *
 * What can be seen depends on the sizes. Beside a merge sort of the 3n half-edges, a scan over 1/k
 * of the n^2 pairs at 4 instructions each has this share (tests/unit/test_growth.c holds the
 * table):
 *
 *     seven sizes     k = 16   32   64   256
 *     128 ... 8192     0.68  0.52  0.35  0.12      undecided, and nine sizes fail them all
 *     256 ... 16384    0.80  0.67  0.50  0.20
 *
 * A first look at five of the seven, 128 ... 1024 and 8192, saves a third of the time where nothing
 * is to be seen. On the counts of the solutions of `make growth`, and these varied by 0.3 and 1 %,
 * it passes nothing that all seven and then nine would fail, down to a term of 1/256 of all pairs,
 * and 9 of 10 right ones.
 *
 * Beside a cheap linear kernel 1/256 shows sooner. Counts that vary by 0.3 % from input to input
 * fail no linear or n lg n kernel in 1000 trials, nor do they at 1 %. Finite sizes cannot tell more
 * than "grows like ... on these inputs". */
#ifndef BENCH_MEASURE_GROWTH_H
#define BENCH_MEASURE_GROWTH_H

#include "reference/base/error.h"

#include <stdint.h>

enum growth_class {
    GROWTH_CONSTANT,
    GROWTH_N,
    GROWTH_N_LG_N,
    GROWTH_N_SQRT_N,
    GROWTH_N_SQUARED,
    GROWTH_N_CUBED, /* found, never allowed */
    GROWTH_CLASS_COUNT
};

/* "1", "n", "n lg n", "n^1.5", "n^2", "n^3": the names in exercise.json and in results. */
const char *growth_class_name(enum growth_class class);

/* The class of that name. Returns 0, or -1 when there is none that can be allowed. */
int growth_class_find(const char *name, enum growth_class *class) MUST_CHECK;

/* The class's term at n: 1, n, n lg n, ... */
double growth_term(enum growth_class class, double n);

enum growth_decision {
    GROWTH_PASS,
    GROWTH_FAIL,
    GROWTH_UNDECIDED /* measure more doublings, fit all sizes again, and look closer */
};

/* How much is decided on these sizes. Sizes cost time, and most programs need few. */
enum growth_look {
    GROWTH_FIRST_LOOK, /* some sizes are left out, not the largest: only what is clear passes */
    GROWTH_FULL_LOOK,
    GROWTH_LAST_LOOK /* nothing is left undecided */
};

enum { GROWTH_SIZES_MIN = 4, GROWTH_SIZES_MAX = 24 };

struct growth_fit {
    enum growth_decision decision;
    enum growth_class class;                /* for people: the largest class that matters */
    double exponent;                        /* slope of log count over log n, top four sizes */
    double excess;                          /* share of the terms above `allowed` at the largest
                                               size, 0..1 */
    double share[GROWTH_CLASS_COUNT];       /* of each term at the largest size; sums to about 1 */
    double coefficient[GROWTH_CLASS_COUNT]; /* instructions */
    double residual;                        /* root mean square of the relative residuals */
    int first_used;                         /* sizes before this one were left out, because there
                                               the constant term was above 20 % */
};

/* Fits and decides.
 *
 * sizes, counts  `count` of each, GROWTH_SIZES_MIN..MAX; sizes rising and > 0, counts > 0
 * allowed        upper bound, not GROWTH_N_CUBED
 * look           first: excess <= 2 % and residual <= 5 % passes, else UNDECIDED;
 *                full: excess <= 10 % passes, else UNDECIDED: nothing fails without more sizes;
 *                last: >= 15 % fails, when there is evidence, else passes
 * Evidence is: three sizes more than terms; a slope of the top four sizes above the allowed class by
 * 0.3 of the excess (by 0.25 where the residual is above 3 %); and that the allowed terms with two
 * steps, at whatever sizes, explain the counts three times as badly as the curve does. A radix sort
 * that needs one more pass, a table that grows, data that leave a cache are steps: doubt counts for
 * the student.
 *
 * returns        0, or -1 and *err for arguments out of range
 * Cost: some 250 small least squares, at the last look 9,000 more; below 10 ms. */
int growth_fit(const int64_t *sizes, const int64_t *counts, int count, enum growth_class allowed,
               enum growth_look look, struct growth_fit *fit, struct error *err) MUST_CHECK;

#endif
