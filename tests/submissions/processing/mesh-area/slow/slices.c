/* Cuts every triangle into twelve slices from its first corner and adds the areas of these.
 * expect: too-much-work */
#include "mesh-area.h"

#include <math.h>
#include <stddef.h>

enum { SLICES = 12 };

static double area_of_slice(const float *a, const float *b, const float *c, int slice)
{
    double begin = (double)slice / SLICES, end = (double)(slice + 1) / SLICES;
    double u[3], v[3];
    for (int i = 0; i < 3; i++) {
        double along = (double)c[i] - (double)b[i], from = (double)b[i] - (double)a[i];
        u[i] = from + begin * along;
        v[i] = from + end * along;
    }
    double x = u[1] * v[2] - u[2] * v[1];
    double y = u[2] * v[0] - u[0] * v[2];
    double z = u[0] * v[1] - u[1] * v[0];
    return 0.5 * sqrt(x * x + y * y + z * z);
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
        for (int slice = 0; slice < SLICES; slice++)
            area += area_of_slice(a, b, c, slice);
    }
    return area;
}
