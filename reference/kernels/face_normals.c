/* A normal for each triangle; see normals.h. */
#include "reference/kernels/normals.h"

#include "reference/kernels/order.h"

#include <math.h>

size_t face_normals_output_bytes(int64_t vertex_count, int64_t triangle_count)
{
    (void)vertex_count;
    return 12 * (size_t)triangle_count + 64;
}

int64_t face_normals_moved_bytes(int64_t vertex_count, int64_t triangle_count, int64_t normal_count)
{
    return 12 * triangle_count + 12 * vertex_count + 12 * normal_count;
}

static void write_normal(const float *a, const float *b, const float *c, float *normal)
{
    double ux = (double)b[0] - (double)a[0], vx = (double)c[0] - (double)a[0];
    double uy = (double)b[1] - (double)a[1], vy = (double)c[1] - (double)a[1];
    double uz = (double)b[2] - (double)a[2], vz = (double)c[2] - (double)a[2];
    double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    double squared = x * x + y * y + z * z;
    double scale = squared > 0 ? 1 / sqrt(squared) : 0;
    normal[0] = (float)(x * scale);
    normal[1] = (float)(y * scale);
    normal[2] = (float)(z * scale);
}

int64_t face_normals_plain(const struct mesh *mesh, void *scratch, void *output)
{
    (void)scratch;
    const float *p = mesh->positions;
    const int32_t *t = mesh->triangles;
    const bool is_scattered = order_is_scattered(mesh);
    float *normal = output;
    for (int32_t left = mesh->triangle_count; left > 0; left--, t += 3, normal += 3) {
        if (is_scattered && left > CORNERS_AHEAD)
            prefetch_corners(p, t + 3 * CORNERS_AHEAD);
        write_normal(p + 3 * (size_t)t[0], p + 3 * (size_t)t[1], p + 3 * (size_t)t[2], normal);
    }
    return mesh->triangle_count;
}
