/* Calls itself for every triangle: the stack ends before a million.
 * fails: many-triangles */
#include "mesh-area.h"

#include <math.h>
#include <stddef.h>

static double area_of(const float *a, const float *b, const float *c)
{
    double u[3], v[3];
    for (int i = 0; i < 3; i++) {
        u[i] = (double)b[i] - (double)a[i];
        v[i] = (double)c[i] - (double)a[i];
    }
    double x = u[1] * v[2] - u[2] * v[1];
    double y = u[2] * v[0] - u[0] * v[2];
    double z = u[0] * v[1] - u[1] * v[0];
    return 0.5 * sqrt(x * x + y * y + z * z);
}

static double area_from(const float *vertices, const int32_t *triangles, int32_t t,
                        int32_t triangle_count)
{
    if (t == triangle_count)
        return 0;
    const float *a = vertices + 3 * (size_t)triangles[3 * (size_t)t];
    const float *b = vertices + 3 * (size_t)triangles[3 * (size_t)t + 1];
    const float *c = vertices + 3 * (size_t)triangles[3 * (size_t)t + 2];
    return area_of(a, b, c) + area_from(vertices, triangles, t + 1, triangle_count);
}

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    return area_from(vertices, triangles, 0, triangle_count);
}
