/* The middle of few numbers from a skewed distribution, and how sure it is.
 *
 * Times on a shared machine are skewed and come in clusters, so nothing here assumes a normal
 * distribution: the interval is that of the sign test, two of the sorted numbers, and it covers the
 * true median with at least the stated confidence whatever the distribution is.
 *
 * Source: the distribution-free confidence interval for the median; e.g. Conover, "Practical
 * Nonparametric Statistics", 3.2. */
#ifndef BENCH_MEASURE_INTERVAL_H
#define BENCH_MEASURE_INTERVAL_H

enum { INTERVAL_VALUES_MAX = 64 };

struct interval {
    double median, low, high;
    double least;      /* the smallest value */
    double confidence; /* of low ... high: >= 0.95 from 6 values on; 1 - 2^(1 - count) below */
    int count;
};

/* Median and interval of values > 0. The median of an even count is the geometric mean of the two
 * in the middle, so that the median of ratios a/b is one over the median of b/a.
 *
 * values  `count` of them, 0 ... INTERVAL_VALUES_MAX, finite and > 0, in any order; with count 0
 *         everything is 0
 * Cost: a sort. */
struct interval interval_of(const double *values, int count);

/* The same of the ratios above[i] / below[i] of pairs measured together. */
struct interval interval_of_ratios(const double *above, const double *below, int count);

/* Whether the interval is too wide to say more than its ends: either end is more than a quarter
 * away from the median. */
int interval_too_noisy(const struct interval *interval);

#endif
