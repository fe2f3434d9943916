/* Claims as many bytes, vertices and triangles as there can be, behind a small block.
 * expect: wrong-answer
 * fails: voxels, voxels-odd, mesh-vertices, mesh-triangles, measured-memory
 */
#include "memory-voxels-vs-mesh.h"

#include <stdlib.h>

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

int voxel_sphere_build(int32_t k, struct voxel_sphere *sphere)
{
    (void)k;
    sphere->byte_count = INT64_MAX;
    sphere->bits = malloc(1);
    return 0;
}

/* ---------------------------------------------------------------------- mesh */

int mesh_sphere_build(int32_t k, struct mesh_sphere *sphere)
{
    (void)k;
    sphere->vertices = malloc(1);
    sphere->triangles = NULL;
    sphere->vertex_count = INT32_MAX;
    sphere->triangle_count = INT32_MIN;
    return 0;
}
