/* Computes in the plane: forgets that z exists. */
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
        double x1 = (double)b[0] - (double)a[0], y1 = (double)b[1] - (double)a[1];
        double x2 = (double)c[0] - (double)a[0], y2 = (double)c[1] - (double)a[1];
        area += 0.5 * fabs(x1 * y2 - x2 * y1);
    }
    return area;
}
