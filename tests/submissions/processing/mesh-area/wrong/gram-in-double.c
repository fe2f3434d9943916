/* The Gram determinant in double: two nearly equal numbers are subtracted for a needle.
 * fails: needles */
#include "mesh-area.h"

#include <math.h>
#include <stddef.h>

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    double area = 0;
    for (int32_t t = 0; t < triangle_count; t++) {
        const float *a = vertices + 3 * (size_t)triangles[3 * (size_t)t];
        const float *b = vertices + 3 * (size_t)triangles[3 * (size_t)t + 1];
        const float *c = vertices + 3 * (size_t)triangles[3 * (size_t)t + 2];
        double uu = 0, vv = 0, uv = 0;
        for (int i = 0; i < 3; i++) {
            double u = (double)b[i] - (double)a[i], v = (double)c[i] - (double)a[i];
            uu += u * u;
            vv += v * v;
            uv += u * v;
        }
        double square = uu * vv - uv * uv;
        area += square > 0 ? 0.5 * sqrt(square) : 0;
    }
    return area;
}
