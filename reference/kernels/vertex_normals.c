/* A normal for each vertex, weighted by area; see normals.h. */
#include "reference/kernels/normals.h"

#include "reference/kernels/order.h"

#include <math.h>
#include <string.h>

size_t vertex_normals_scratch_bytes(int64_t vertex_count, int64_t triangle_count)
{
    (void)triangle_count;
    return 16 * (size_t)vertex_count + 64;
}

size_t vertex_normals_output_bytes(int64_t vertex_count, int64_t triangle_count)
{
    (void)triangle_count;
    return 12 * (size_t)vertex_count + 64;
}

int64_t vertex_normals_moved_bytes(int64_t vertex_count, int64_t triangle_count,
                                   int64_t normal_count)
{
    return 12 * triangle_count + 12 * vertex_count + 12 * normal_count;
}

/* Sums stand four floats apart, so that a vector variant adds one in one step. */
static void add_triangle(const float *p, const int32_t t[3], float *sums)
{
    float cross[3];
    triangle_cross(p, t, cross);
    for (int corner = 0; corner < 3; corner++) {
        float *sum = sums + 4 * (size_t)t[corner];
        sum[0] += cross[0];
        sum[1] += cross[1];
        sum[2] += cross[2];
    }
}

void vertex_normal_write(const float sum[3], float normal[3])
{
    double x = (double)sum[0], y = (double)sum[1], z = (double)sum[2];
    double squared = x * x + y * y + z * z;
    double scale = squared > 0 ? 1 / sqrt(squared) : 0;
    normal[0] = (float)(x * scale);
    normal[1] = (float)(y * scale);
    normal[2] = (float)(z * scale);
}

int64_t vertex_normals_plain(const struct mesh *mesh, void *scratch, void *output)
{
    float *sums = scratch, *normals = output;
    memset(sums, 0, 16 * (size_t)mesh->vertex_count);
    const bool is_scattered = order_is_scattered(mesh);
    const float *p = mesh->positions;
    const int32_t *t = mesh->triangles;
    for (int32_t left = mesh->triangle_count; left > 0; left--, t += 3) {
        if (is_scattered && left > CORNERS_AHEAD) {
            prefetch_corners(p, t + 3 * CORNERS_AHEAD);
            for (int k = 3 * CORNERS_AHEAD; k < 3 * CORNERS_AHEAD + 3; k++)
                __builtin_prefetch(sums + 4 * (size_t)t[k], 1);
        }
        add_triangle(p, t, sums);
    }
    for (size_t v = 0; v < (size_t)mesh->vertex_count; v++)
        vertex_normal_write(sums + 4 * v, normals + 3 * v);
    return mesh->vertex_count;
}
