/* Problem 4.1: a sphere as one bit a cell, and as a mesh of meridians and parallels. */
#include "memory-voxels-vs-mesh.h"

#include <math.h>
#include <stdlib.h>

static const double PI = 3.14159265358979323846;

int64_t voxel_sphere_bytes(int32_t k)
{
    int64_t cells = (int64_t)k * k * k;
    return (cells + 7) / 8;
}

static int64_t vertex_count_of(int64_t k)
{
    return k * k;
}

static int64_t triangle_count_of(int64_t k)
{
    return 2 * k * (k - 1);
}

int64_t mesh_sphere_bytes(int32_t k)
{
    return vertex_count_of(k) * 3 * (int64_t)sizeof(float) +
           triangle_count_of(k) * 3 * (int64_t)sizeof(int32_t);
}

double voxel_sphere_kilobytes(void)
{
    return (double)voxel_sphere_bytes(16) / 1024;
}

double mesh_sphere_kilobytes(void)
{
    return (double)mesh_sphere_bytes(16) / 1024;
}

double voxel_sphere_megabytes(void)
{
    return (double)voxel_sphere_bytes(1024) / 1024 / 1024;
}

double mesh_sphere_megabytes(void)
{
    return (double)mesh_sphere_bytes(1024) / 1024 / 1024;
}

int32_t smallest_k_for_mesh(void)
{
    int32_t k = 3;
    while (mesh_sphere_bytes(k) >= voxel_sphere_bytes(k))
        k++;
    return k;
}

/* -------------------------------------------------------------------- voxels */

/* Everything is scaled by 2k, so that all numbers are whole and the test is exact. */
int voxel_sphere_build(int32_t k, struct voxel_sphere *sphere)
{
    sphere->byte_count = voxel_sphere_bytes(k);
    sphere->bits = calloc((size_t)sphere->byte_count, 1);
    if (!sphere->bits)
        return OUT_OF_MEMORY;
    int64_t radius_squared = (int64_t)k * k;
    int64_t bit = 0;
    for (int64_t z = 1 - k; z < k; z += 2) {
        for (int64_t y = 1 - k; y < k; y += 2) {
            int64_t left = radius_squared - y * y - z * z;
            for (int64_t x = 1 - k; x < k; x += 2, bit++)
                if (x * x <= left)
                    sphere->bits[bit / 8] |= (uint8_t)(1 << bit % 8);
        }
    }
    return 0;
}

/* ---------------------------------------------------------------------- mesh */

/* Vertex i of meridian j is number j * k + i. The first meridian is placed in the plane y = 0, the
 * others are that one turned around the z axis. */
static void place_vertices(int32_t k, float *vertices)
{
    for (int32_t i = 0; i < k; i++) {
        double from_pole = PI * i / (k - 1);
        vertices[3 * i] = (float)(0.5 * sin(from_pole));
        vertices[3 * i + 1] = 0;
        vertices[3 * i + 2] = (float)(0.5 * cos(from_pole));
    }
    for (int32_t j = 1; j < k; j++) {
        float *meridian = vertices + 3 * (int64_t)j * k;
        float cosine = (float)cos(2 * PI * j / k);
        float sine = (float)sin(2 * PI * j / k);
        for (int32_t i = 0; i < k; i++) {
            meridian[3 * i] = vertices[3 * i] * cosine;
            meridian[3 * i + 1] = vertices[3 * i] * sine;
            meridian[3 * i + 2] = vertices[3 * i + 2];
        }
    }
}

static void join_vertices(int32_t k, int32_t *triangles)
{
    int32_t *at = triangles;
    for (int32_t j = 0; j < k; j++) {
        int32_t here = j * k;
        int32_t next = (j + 1) % k * k;
        for (int32_t i = 0; i + 1 < k; i++) {
            *at++ = here + i;
            *at++ = here + i + 1;
            *at++ = next + i + 1;
            *at++ = here + i;
            *at++ = next + i + 1;
            *at++ = next + i;
        }
    }
}

int mesh_sphere_build(int32_t k, struct mesh_sphere *sphere)
{
    int64_t vertex_count = vertex_count_of(k);
    int64_t triangle_count = triangle_count_of(k);
    sphere->vertices = malloc((size_t)vertex_count * 3 * sizeof *sphere->vertices);
    sphere->triangles = malloc((size_t)triangle_count * 3 * sizeof *sphere->triangles);
    if (!sphere->vertices || !sphere->triangles) {
        free(sphere->vertices);
        free(sphere->triangles);
        return OUT_OF_MEMORY;
    }
    sphere->vertex_count = (int32_t)vertex_count;
    sphere->triangle_count = (int32_t)triangle_count;
    place_vertices(k, sphere->vertices);
    join_vertices(k, sphere->triangles);
    return 0;
}
