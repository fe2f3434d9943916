/* Sines and cosines in tables of their own, freed at the end; voxels by eight at a time. */
#include "memory-voxels-vs-mesh.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

int64_t voxel_sphere_bytes(int32_t k)
{
    uint64_t cells = (uint64_t)k * (uint64_t)k * (uint64_t)k;
    return (int64_t)((cells + 7) / 8);
}

int64_t mesh_sphere_bytes(int32_t k)
{
    int64_t vertices = (int64_t)k * k;
    int64_t cells = (int64_t)k * (k - 1);
    return vertices * (int64_t)(3 * sizeof(float)) + cells * (int64_t)(6 * sizeof(int32_t));
}

double voxel_sphere_kilobytes(void)
{
    return (double)voxel_sphere_bytes(16) / (1 << 10);
}

double mesh_sphere_kilobytes(void)
{
    return (double)mesh_sphere_bytes(16) / (1 << 10);
}

double voxel_sphere_megabytes(void)
{
    return (double)voxel_sphere_bytes(1 << 10) / (1 << 20);
}

double mesh_sphere_megabytes(void)
{
    return (double)mesh_sphere_bytes(1 << 10) / (1 << 20);
}

int32_t smallest_k_for_mesh(void)
{
    for (int32_t k = 3;; k++)
        if (mesh_sphere_bytes(k) < voxel_sphere_bytes(k))
            return k;
}

static bool inside(int32_t k, int64_t cell)
{
    int64_t x = 2 * (cell % k) - k + 1;
    int64_t y = 2 * (cell / k % k) - k + 1;
    int64_t z = 2 * (cell / k / k) - k + 1;
    return x * x + y * y + z * z <= (int64_t)k * k;
}

int voxel_sphere_build(int32_t k, struct voxel_sphere *sphere)
{
    int64_t cell_count = (int64_t)k * k * k;
    sphere->byte_count = voxel_sphere_bytes(k);
    sphere->bits = malloc((size_t)sphere->byte_count);
    if (!sphere->bits)
        return OUT_OF_MEMORY;
    for (int64_t byte = 0; byte < sphere->byte_count; byte++) {
        unsigned value = 0;
        for (int bit = 7; bit >= 0; bit--) {
            int64_t cell = 8 * byte + bit;
            value = 2 * value + (cell < cell_count && inside(k, cell));
        }
        sphere->bits[byte] = (uint8_t)value;
    }
    return 0;
}

/* cosine and sine of step * i for i in 0 ... count - 1, in one block; NULL when out of memory. */
static double *circle(int32_t count, double step)
{
    double *table = malloc(2 * (size_t)count * sizeof *table);
    for (int32_t i = 0; table && i < count; i++) {
        table[2 * i] = cos(step * i);
        table[2 * i + 1] = sin(step * i);
    }
    return table;
}

static void fill(int32_t k, const double *down, const double *around, struct mesh_sphere *sphere)
{
    float *vertex = sphere->vertices;
    int32_t *corner = sphere->triangles;
    for (int32_t j = 0; j < k; j++) {
        int32_t first = j * k, next = j + 1 < k ? first + k : 0;
        for (int32_t i = 0; i < k; i++, vertex += 3) {
            vertex[0] = (float)(down[2 * i + 1] * around[2 * j] / 2);
            vertex[1] = (float)(down[2 * i + 1] * around[2 * j + 1] / 2);
            vertex[2] = (float)(down[2 * i] / 2);
            if (i == 0)
                continue;
            const int32_t square[6] = {next + i,      next + i - 1, first + i - 1,
                                       first + i - 1, first + i,    next + i};
            for (int c = 0; c < 6; c++)
                *corner++ = square[c];
        }
    }
}

int mesh_sphere_build(int32_t k, struct mesh_sphere *sphere)
{
    double pi = 4 * atan(1);
    double *down = circle(k, pi / (k - 1)), *around = circle(k, 2 * pi / k);
    sphere->vertex_count = k * k;
    sphere->triangle_count = k * (k - 1) * 2;
    sphere->vertices = malloc((size_t)sphere->vertex_count * sizeof(float[3]));
    sphere->triangles = malloc((size_t)sphere->triangle_count * sizeof(int32_t[3]));
    bool complete = down && around && sphere->vertices && sphere->triangles;
    if (complete) {
        fill(k, down, around, sphere);
    } else {
        free(sphere->vertices);
        free(sphere->triangles);
    }
    free(down);
    free(around);
    return complete ? 0 : OUT_OF_MEMORY;
}
