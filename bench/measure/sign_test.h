/* Is the submission slower than `bound` times the reference? A sequential sign test on the ratios
 * of paired runs.
 *
 * Each pair says only above or below. When one side leads by 9 it has won; after 150 pairs without
 * a winner the test is inconclusive, and that counts for the student. Noise that makes a pair fall
 * on the wrong side with probability p decides wrongly with probability about (p / (1 - p))^9:
 * 4e-9 at p = 0.1, 5e-4 at p = 0.3. A true ratio within some 5 % of the bound is a coin toss for
 * any rule: put the bound where no right solution is near.
 *
 * Source: Wald's sequential probability ratio test for a Bernoulli variable, symmetric case. */
#ifndef BENCH_MEASURE_SIGN_TEST_H
#define BENCH_MEASURE_SIGN_TEST_H

enum { SIGN_TEST_LEAD = 9, SIGN_TEST_PAIRS_MAX = 150 };

enum sign_decision {
    SIGN_OPEN,        /* another pair, please */
    SIGN_WITHIN,      /* the ratio is below the bound */
    SIGN_ABOVE,       /* the ratio is above the bound */
    SIGN_INCONCLUSIVE /* no winner after SIGN_TEST_PAIRS_MAX pairs: for the student */
};

/* Begin with {.bound = ...}; fields are read-only for users. */
struct sign_test {
    double bound;
    int above, below; /* pairs so far */
    int lost;         /* pairs without a usable ratio; they use up pairs and weigh nothing */
};

/* Adds one pair. `ratio` is time of the submission over time of the reference; NaN, infinite or
 * <= 0 counts as lost, equal to the bound as below. A decided test ignores further pairs. */
enum sign_decision sign_test_add(struct sign_test *test, double ratio);

/* Where the test stands. */
enum sign_decision sign_test_decision(const struct sign_test *test);

#endif
