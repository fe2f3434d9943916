/* Area in the plainest way; see area.h. */
#include "reference/kernels/area.h"

#include "reference/kernels/order.h"

#include <math.h>

size_t area_output_bytes(int64_t vertex_count, int64_t triangle_count)
{
    (void)vertex_count;
    (void)triangle_count;
    return 64;
}

int64_t area_moved_bytes(int64_t vertex_count, int64_t triangle_count, int64_t record_count)
{
    return 12 * triangle_count + 12 * vertex_count + 8 * record_count;
}

static double twice_triangle_area(const float *a, const float *b, const float *c)
{
    double ux = (double)b[0] - (double)a[0], vx = (double)c[0] - (double)a[0];
    double uy = (double)b[1] - (double)a[1], vy = (double)c[1] - (double)a[1];
    double uz = (double)b[2] - (double)a[2], vz = (double)c[2] - (double)a[2];
    double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    return sqrt(x * x + y * y + z * z);
}

int64_t area_plain(const struct mesh *mesh, void *scratch, void *output)
{
    (void)scratch;
    const float *p = mesh->positions;
    const int32_t *t = mesh->triangles;
    const bool is_scattered = order_is_scattered(mesh);
    double twice_area = 0;
    for (int32_t left = mesh->triangle_count; left > 0; left--, t += 3) {
        if (is_scattered && left > CORNERS_AHEAD)
            prefetch_corners(p, t + 3 * CORNERS_AHEAD);
        twice_area +=
            twice_triangle_area(p + 3 * (size_t)t[0], p + 3 * (size_t)t[1], p + 3 * (size_t)t[2]);
    }
    *(double *)output = 0.5 * twice_area;
    return 1;
}
