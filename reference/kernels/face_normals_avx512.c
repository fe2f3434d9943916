/* A normal for each triangle, eight at a time; see normals.h. */
#include "reference/kernels/normals.h"
#include "reference/kernels/order.h"
#include "reference/kernels/points_avx512.h"

#if defined(__x86_64__)

TARGET_AVX512 int64_t face_normals_avx512(const struct mesh *mesh, void *scratch, void *output)
{
    enum { AHEAD = 24 };
    const float *positions = mesh->positions;
    const int32_t *t = mesh->triangles;
    float *normal = output;
    int32_t left = mesh->triangle_count;
    if (order_is_scattered(mesh))
        for (; left >= AHEAD + 8; left -= 8, t += 24, normal += 24) {
            prefetch_corners8(positions, t + 3 * AHEAD);
            store_units8(normal, load_cross8(positions, t));
        }
    for (; left >= 8; left -= 8, t += 24, normal += 24)
        store_units8(normal, load_cross8(positions, t));
    const struct mesh rest = {mesh->positions, mesh->triangles + (t - mesh->triangles),
                              mesh->vertex_count, left};
    face_normals_plain(&rest, scratch, normal);
    return mesh->triangle_count;
}

#endif
