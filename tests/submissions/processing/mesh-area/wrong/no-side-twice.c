/* Leaves out a triangle when its first side was met in the same direction before: it takes it to
 * be listed twice.
 * fails: orientation */
#include "mesh-area.h"

#include <math.h>
#include <stdlib.h>

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

static size_t slot_of(const uint64_t *slots, size_t mask, uint64_t key)
{
    size_t i = (key * 0x9E3779B97F4A7C15u >> 20) & mask;
    while (slots[i] != 0 && slots[i] != key)
        i = (i + 1) & mask;
    return i;
}

static uint64_t key_of(int32_t from, int32_t to)
{
    return ((uint64_t)from << 32 | (uint64_t)to) + 1;
}

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    double area = 0;
    size_t mask = 15;
    while (mask < 6 * (size_t)triangle_count)
        mask = 2 * mask + 1;
    uint64_t *slots = calloc(mask + 1, sizeof *slots);
    if (!slots)
        return OUT_OF_MEMORY;
    for (int32_t t = 0; t < triangle_count; t++) {
        const float *a = vertices + 3 * (size_t)triangles[3 * (size_t)t];
        const float *b = vertices + 3 * (size_t)triangles[3 * (size_t)t + 1];
        const float *c = vertices + 3 * (size_t)triangles[3 * (size_t)t + 2];
        const int32_t *v = triangles + 3 * (size_t)t;
        if (slots[slot_of(slots, mask, key_of(v[0], v[1]))] == 0)
            area += area_of(a, b, c);
        for (int k = 0; k < 3; k++) {
            uint64_t key = key_of(v[k], v[(k + 1) % 3]);
            slots[slot_of(slots, mask, key)] = key;
        }
    }
    free(slots);
    return area;
}
