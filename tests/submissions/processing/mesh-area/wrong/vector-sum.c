/* Adds the cross products as vectors and takes the length at the end. */
#include "mesh-area.h"

#include <math.h>
#include <stddef.h>

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    double sum[3] = {0, 0, 0};
    for (int32_t t = 0; t < triangle_count; t++) {
        const float *a = vertices + 3 * (size_t)triangles[3 * (size_t)t];
        const float *b = vertices + 3 * (size_t)triangles[3 * (size_t)t + 1];
        const float *c = vertices + 3 * (size_t)triangles[3 * (size_t)t + 2];
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, k = (i + 2) % 3;
            sum[i] += ((double)b[j] - (double)a[j]) * ((double)c[k] - (double)a[k]) -
                      ((double)b[k] - (double)a[k]) * ((double)c[j] - (double)a[j]);
        }
    }
    return 0.5 * sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
}
