/* Heron's formula in float. */
#include "mesh-area.h"

#include <math.h>
#include <stddef.h>

static float distance(const float *p, const float *q)
{
    float x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
    return sqrtf(x * x + y * y + z * z);
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
        float p = distance(a, b), q = distance(b, c), r = distance(c, a);
        float s = (p + q + r) / 2, square = s * (s - p) * (s - q) * (s - r);
        area += square > 0 ? (double)sqrtf(square) : 0;
    }
    return area;
}
