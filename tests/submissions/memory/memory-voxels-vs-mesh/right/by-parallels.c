/* Numbers the vertices parallel by parallel, cuts by the other diagonal; voxels with a test in
 * double. */
#include "memory-voxels-vs-mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int64_t voxel_sphere_bytes(int32_t k)
{
    int64_t cells = (int64_t)k * k * k;
    return cells / 8 + (cells % 8 != 0);
}

int64_t mesh_sphere_bytes(int32_t k)
{
    return 36LL * k * k - 24LL * k;
}

double voxel_sphere_kilobytes(void)
{
    return 0.5;
}

double mesh_sphere_kilobytes(void)
{
    return 8.63;
}

double voxel_sphere_megabytes(void)
{
    return 128;
}

double mesh_sphere_megabytes(void)
{
    return 35.98;
}

int32_t smallest_k_for_mesh(void)
{
    return 288;
}

static double centre(int32_t k, int32_t x)
{
    return (x + 0.5) / k - 0.5;
}

int voxel_sphere_build(int32_t k, struct voxel_sphere *sphere)
{
    int64_t bytes = voxel_sphere_bytes(k);
    uint8_t *bits = malloc((size_t)bytes);
    if (bits == NULL)
        return OUT_OF_MEMORY;
    memset(bits, 0, (size_t)bytes);
    for (int32_t z = 0; z < k; z++)
        for (int32_t y = 0; y < k; y++)
            for (int32_t x = 0; x < k; x++) {
                double a = centre(k, x), b = centre(k, y), c = centre(k, z);
                int64_t number = x + (int64_t)k * (y + (int64_t)k * z);
                if (a * a + b * b + c * c <= 0.5 * 0.5)
                    bits[number >> 3] |= (uint8_t)(1u << (number & 7));
            }
    sphere->bits = bits;
    sphere->byte_count = bytes;
    return 0;
}

static void put(int32_t **at, int32_t a, int32_t b, int32_t c)
{
    (*at)[0] = a;
    (*at)[1] = b;
    (*at)[2] = c;
    *at += 3;
}

int mesh_sphere_build(int32_t k, struct mesh_sphere *sphere)
{
    const float pi = 3.14159265f;
    sphere->vertex_count = k * k;
    sphere->triangle_count = 2 * k * (k - 1);
    sphere->vertices = malloc(12 * (size_t)sphere->vertex_count);
    if (sphere->vertices == NULL)
        return OUT_OF_MEMORY;
    sphere->triangles = malloc(12 * (size_t)sphere->triangle_count);
    if (sphere->triangles == NULL) {
        free(sphere->vertices);
        return OUT_OF_MEMORY;
    }
    int32_t *at = sphere->triangles;
    for (int32_t i = 0; i < k; i++) {
        float theta = pi * (float)i / (float)(k - 1);
        for (int32_t j = 0; j < k; j++) {
            float phi = 2 * pi * (float)j / (float)k;
            float *vertex = sphere->vertices + 3 * (i * k + j);
            vertex[0] = 0.5f * sinf(theta) * cosf(phi);
            vertex[1] = 0.5f * sinf(theta) * sinf(phi);
            vertex[2] = 0.5f * cosf(theta);
            int32_t east = i * k + (j + 1) % k;
            if (i + 1 < k) {
                put(&at, i * k + j, i * k + j + k, east);
                put(&at, east, i * k + j + k, east + k);
            }
        }
    }
    return 0;
}
