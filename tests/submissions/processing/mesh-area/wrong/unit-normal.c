/* Projects onto the unit normal, which a triangle without area does not have: 0 / 0.
 * fails: degenerate */
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
        double n[3], square = 0, doubled = 0;
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, k = (i + 2) % 3;
            n[i] = ((double)b[j] - (double)a[j]) * ((double)c[k] - (double)a[k]) -
                   ((double)b[k] - (double)a[k]) * ((double)c[j] - (double)a[j]);
            square += n[i] * n[i];
        }
        for (int i = 0; i < 3; i++)
            doubled += n[i] * (n[i] / sqrt(square));
        area += 0.5 * doubled;
    }
    return area;
}
