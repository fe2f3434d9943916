/* The middle of few numbers and how sure it is; see interval.h. */
#include "bench/measure/interval.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double CONFIDENCE = 0.95;
static const double NOISY = 1.25;

static int by_value(const void *left, const void *right)
{
    double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

/* The how-manieth smallest (0-based) of `count` is the lower end, and with what confidence: the
 * median lies outside of the interval only when at most `rank` of the values are on one side of it.
 */
static int lower_rank(int count, double *confidence)
{
    double probability = pow(0.5, count), tail = probability; /* of 0 values on one side */
    int rank = 0;
    while (2 * rank + 2 < count) {
        probability *= (double)(count - rank) / (rank + 1);
        if (1 - 2 * (tail + probability) < CONFIDENCE)
            break;
        tail += probability;
        rank++;
    }
    *confidence = 1 - 2 * tail;
    return rank;
}

struct interval interval_of(const double *values, int count)
{
    struct interval interval = {.count = count};
    double sorted[INTERVAL_VALUES_MAX];
    if (count <= 0 || count > INTERVAL_VALUES_MAX)
        return interval;
    memcpy(sorted, values, (size_t)count * sizeof *sorted);
    qsort(sorted, (size_t)count, sizeof *sorted, by_value);
    int rank = lower_rank(count, &interval.confidence);
    interval.median =
        count % 2 ? sorted[count / 2] : sqrt(sorted[count / 2 - 1] * sorted[count / 2]);
    interval.low = sorted[rank];
    interval.high = sorted[count - 1 - rank];
    interval.least = sorted[0];
    return interval;
}

struct interval interval_of_ratios(const double *above, const double *below, int count)
{
    double ratios[INTERVAL_VALUES_MAX];
    if (count <= 0 || count > INTERVAL_VALUES_MAX)
        return interval_of(NULL, 0);
    for (int i = 0; i < count; i++)
        ratios[i] = above[i] / below[i];
    return interval_of(ratios, count);
}

int interval_too_noisy(const struct interval *interval)
{
    return interval->high > NOISY * interval->median || interval->low * NOISY < interval->median;
}
