/* Copies the corners of all triangles twice, 144 bytes a triangle, before it adds anything.
 * Ten million triangles take more than there is.
 * expect: out-of-memory
 * fails: many-triangles */
#include "mesh-area.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    double area = 0;
    size_t bytes = 9 * (size_t)triangle_count * sizeof(double) + 1;
    double *corners = malloc(bytes), *copy = malloc(bytes);
    if (!corners || !copy) {
        free(corners);
        free(copy);
        return OUT_OF_MEMORY;
    }
    for (int32_t t = 0; t < triangle_count; t++) {
        const float *a = vertices + 3 * (size_t)triangles[3 * (size_t)t];
        const float *b = vertices + 3 * (size_t)triangles[3 * (size_t)t + 1];
        const float *c = vertices + 3 * (size_t)triangles[3 * (size_t)t + 2];
        for (int i = 0; i < 3; i++) {
            corners[9 * (size_t)t + (size_t)i] = (double)a[i];
            corners[9 * (size_t)t + 3 + (size_t)i] = (double)b[i];
            corners[9 * (size_t)t + 6 + (size_t)i] = (double)c[i];
        }
    }
    memcpy(copy, corners, bytes - 1);
    for (int32_t t = 0; t < triangle_count; t++) {
        float part[9];
        for (int i = 0; i < 9; i++)
            part[i] = (float)copy[9 * (size_t)t + (size_t)i];
        area += area_of(part, part + 3, part + 6);
    }
    free(corners);
    free(copy);
    return area;
}
