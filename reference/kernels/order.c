/* Locality of the triangle table, by samples; see order.h. */
#include "reference/kernels/order.h"

#include <stdint.h>

/* Of a triangle and the one after it: whether a corner of one is near a corner of the other. */
static bool is_near_next(const int32_t *t, int32_t near)
{
    for (int i = 0; i < 3; i++)
        for (int k = 3; k < 6; k++) {
            int64_t distance = (int64_t)t[i] - t[k];
            if (distance < near && -distance < near)
                return true;
        }
    return false;
}

bool order_is_scattered(const struct mesh *mesh)
{
    enum { SAMPLES = 256, NEAR = 64, CACHED_VERTICES = 1 << 14 };
    if (mesh->vertex_count < CACHED_VERTICES || mesh->triangle_count < 2 * SAMPLES)
        return false;
    int near_count = 0;
    for (int64_t k = 0; k < SAMPLES; k++) {
        int64_t t = k * (mesh->triangle_count - 1) / SAMPLES;
        near_count += is_near_next(mesh->triangles + 3 * t, NEAR);
    }
    return near_count < SAMPLES / 2;
}

bool order_is_worth_parting(const struct mesh *mesh)
{
    enum { LARGE = 1 << 17 };
    return mesh->vertex_count >= LARGE && order_is_scattered(mesh);
}
