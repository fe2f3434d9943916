/* Computes everything in float. */
#include "mesh-area.h"

#include <math.h>
#include <stddef.h>

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    float area = 0;
    for (int32_t t = 0; t < triangle_count; t++) {
        const float *a = vertices + 3 * (size_t)triangles[3 * (size_t)t];
        const float *b = vertices + 3 * (size_t)triangles[3 * (size_t)t + 1];
        const float *c = vertices + 3 * (size_t)triangles[3 * (size_t)t + 2];
        float n[3];
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, k = (i + 2) % 3;
            n[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
        }
        area += 0.5F * sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    }
    return (double)area;
}
