/* Sine and cosine of rational parts of a turn; see circle.h. */
#include "reference/mesh/circle.h"

/* Taylor's series, for 0 <= x <= pi / 4: the first terms left out are below 1e-17. */
static double sine_series(double x)
{
    double sum = 0.0;
    for (int k = 17; k >= 3; k -= 2)
        sum = (1.0 - sum) * (x * x) / (double)(k * (k - 1));
    return x * (1.0 - sum);
}

static double cosine_series(double x)
{
    double sum = 0.0;
    for (int k = 18; k >= 2; k -= 2)
        sum = (1.0 - sum) * (x * x) / (double)(k * (k - 1));
    return 1.0 - sum;
}

struct circle_point circle_point(int64_t step, int64_t steps)
{
    const double pi = 3.14159265358979323846;
    step %= steps;
    if (step < 0)
        step += steps;
    /* In eighths of a turn: the whole eighths are reduced in integers, without rounding. */
    int64_t octant = 8 * step / steps;
    int64_t rest = 8 * step % steps;
    if (octant % 2 == 1)
        rest = steps - rest; /* mirrored: counted back from the next quarter */
    double x = pi / 4 * ((double)rest / (double)steps);
    double c = cosine_series(x), s = sine_series(x);
    switch (octant) {
    case 0:
        return (struct circle_point){c, s};
    case 1:
        return (struct circle_point){s, c};
    case 2:
        return (struct circle_point){-s, c};
    case 3:
        return (struct circle_point){-c, s};
    case 4:
        return (struct circle_point){-c, -s};
    case 5:
        return (struct circle_point){-s, -c};
    case 6:
        return (struct circle_point){s, -c};
    default:
        return (struct circle_point){c, -s};
    }
}
