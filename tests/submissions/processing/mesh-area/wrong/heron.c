/* Heron's formula: the half perimeter of a needle is nearly its longest side, and the difference
 * loses its digits.
 * fails: needles */
#include "mesh-area.h"

#include <math.h>
#include <stddef.h>

static double distance(const float *p, const float *q)
{
    double x = (double)p[0] - (double)q[0];
    double y = (double)p[1] - (double)q[1];
    double z = (double)p[2] - (double)q[2];
    return sqrt(x * x + y * y + z * z);
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
        double p = distance(a, b), q = distance(b, c), r = distance(c, a);
        double s = (p + q + r) / 2, square = s * (s - p) * (s - q) * (s - r);
        area += square > 0 ? sqrt(square) : 0;
    }
    return area;
}
