/* Problem 4.1. Replace what stands in the functions; memory-voxels-vs-mesh.h says what each must
 * do. */
#include "memory-voxels-vs-mesh.h"

#include <stddef.h>

int64_t voxel_sphere_bytes(int32_t k)
{
    (void)k;
    return 0;
}

int64_t mesh_sphere_bytes(int32_t k)
{
    (void)k;
    return 0;
}

double voxel_sphere_kilobytes(void)
{
    return 0;
}

double mesh_sphere_kilobytes(void)
{
    return 0;
}

double voxel_sphere_megabytes(void)
{
    return 0;
}

double mesh_sphere_megabytes(void)
{
    return 0;
}

int32_t smallest_k_for_mesh(void)
{
    return 0;
}

int voxel_sphere_build(int32_t k, struct voxel_sphere *sphere)
{
    (void)k;
    sphere->bits = NULL;
    sphere->byte_count = 0;
    return 0;
}

int mesh_sphere_build(int32_t k, struct mesh_sphere *sphere)
{
    (void)k;
    sphere->vertices = NULL;
    sphere->triangles = NULL;
    sphere->vertex_count = 0;
    sphere->triangle_count = 0;
    return 0;
}
