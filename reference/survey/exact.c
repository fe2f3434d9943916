/* Exact predicates; see exact.h. */
#include "reference/survey/exact.h"

#include <float.h>
#include <math.h>

/* -- sums without rounding -------------------------------------------------------------------- */

enum { SUM_LIMIT = 48 };

/* A number as parts that do not overlap, the smallest first; no part is 0. */
struct exact_sum {
    double part[SUM_LIMIT + 1];
    int count;
};

static void add_exactly(struct exact_sum *sum, double value)
{
    int kept = 0;
    for (int i = 0; i < sum->count; i++) {
        double total = value + sum->part[i];
        double virtual = total - value;
        double error = (value - (total - virtual)) + (sum->part[i] - virtual);
        value = total;
        if (error != 0)
            sum->part[kept++] = error;
    }
    if (value != 0)
        sum->part[kept++] = value;
    sum->count = kept;
}

static int sign_of(double value)
{
    return (value > 0) - (value < 0);
}

static int sign_of_sum(const struct exact_sum *sum)
{
    return sum->count > 0 ? sign_of(sum->part[sum->count - 1]) : 0;
}

/* Adds x * y * z, for coordinates: x * y has 48 bits, and the product two parts. */
static void add_product(struct exact_sum *sum, double x, double y, double z)
{
    double area = x * y, high = area * z;
    add_exactly(sum, fma(area, z, -high));
    add_exactly(sum, high);
}

/* Adds the determinant of the rows p, q, r, or takes it away. */
static void add_determinant(struct exact_sum *sum, const float *p, const float *q, const float *r,
                            double sign)
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        add_product(sum, sign * (double)p[i], (double)q[j], (double)r[k]);
        add_product(sum, -sign * (double)p[i], (double)q[k], (double)r[j]);
    }
}

/* -- planes ----------------------------------------------------------------------------------- */

static int plane_side_exactly(const float *a, const float *b, const float *c, const float *d)
{
    struct exact_sum sum = {.count = 0};
    add_determinant(&sum, b, c, d, 1);
    add_determinant(&sum, a, c, d, -1);
    add_determinant(&sum, a, b, d, 1);
    add_determinant(&sum, a, b, c, -1);
    return sign_of_sum(&sum);
}

int exact_plane_side(const float a[3], const float b[3], const float c[3], const float d[3])
{
    const double unit = DBL_EPSILON / 2, bound = (7 + 56 * unit) * unit;
    double u[3], v[3], w[3], sum = 0, size = 0;
    for (int i = 0; i < 3; i++) {
        u[i] = (double)b[i] - (double)a[i];
        v[i] = (double)c[i] - (double)a[i];
        w[i] = (double)d[i] - (double)a[i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double one = u[j] * v[k], other = u[k] * v[j];
        sum += w[i] * (one - other);
        size += fabs(w[i]) * (fabs(one) + fabs(other));
    }
    if (fabs(sum) > bound * size)
        return sign_of(sum);
    /* Equal coordinates give a size of 0, and nothing was rounded. */
    return size > 0 ? plane_side_exactly(a, b, c, d) : 0;
}

/* -- lines ------------------------------------------------------------------------------------ */

static int line_side_exactly(const float *a, const float *b, const float *c, int x, int y)
{
    const float *point[3] = {a, b, c};
    struct exact_sum sum = {.count = 0};
    for (int i = 0; i < 3; i++) {
        const float *p = point[i], *q = point[(i + 1) % 3];
        add_exactly(&sum, (double)p[x] * (double)q[y]);
        add_exactly(&sum, -(double)p[y] * (double)q[x]);
    }
    return sign_of_sum(&sum);
}

int exact_line_side(int axis, const float a[3], const float b[3], const float c[3])
{
    const double unit = DBL_EPSILON / 2, bound = (3 + 16 * unit) * unit;
    int x = (axis + 1) % 3, y = (axis + 2) % 3;
    double one = ((double)b[x] - (double)a[x]) * ((double)c[y] - (double)a[y]);
    double other = ((double)b[y] - (double)a[y]) * ((double)c[x] - (double)a[x]);
    double size = fabs(one) + fabs(other);
    if (fabs(one - other) > bound * size)
        return sign_of(one - other);
    return size > 0 ? line_side_exactly(a, b, c, x, y) : 0;
}

bool exact_on_line(const float a[3], const float b[3], const float c[3])
{
    for (int axis = 0; axis < 3; axis++)
        if (exact_line_side(axis, a, b, c) != 0)
            return false;
    return true;
}
