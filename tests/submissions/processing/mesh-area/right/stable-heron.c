/* Heron's formula in Kahan's stable form, in extended precision: the sides of a needle differ in
 * their last digits only. */
#include "mesh-area.h"

#include <math.h>
#include <stddef.h>

static long double distance(const float *p, const float *q)
{
    long double x = (long double)p[0] - (long double)q[0];
    long double y = (long double)p[1] - (long double)q[1];
    long double z = (long double)p[2] - (long double)q[2];
    return sqrtl(x * x + y * y + z * z);
}

static void order(long double *larger, long double *smaller)
{
    if (*larger < *smaller) {
        long double kept = *larger;
        *larger = *smaller;
        *smaller = kept;
    }
}

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    double area = 0;
    for (int32_t t = 0; t < triangle_count; t++) {
        const float *a = vertices + 3 * (size_t)triangles[3 * (size_t)t];
        const float *b = vertices + 3 * (size_t)triangles[3 * (size_t)t + 1];
        const float *c = vertices + 3 * (size_t)triangles[3 * (size_t)t + 2];
        long double p = distance(a, b), q = distance(b, c), r = distance(c, a);
        order(&p, &q);
        order(&p, &r);
        order(&q, &r);
        long double square = (p + (q + r)) * (r - (p - q)) * (r + (p - q)) * (p + (q - r));
        if (square > 0)
            area += (double)(sqrtl(square) / 4);
    }
    return area;
}
