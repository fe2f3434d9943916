/* A normal for each triangle, four at a time; see normals.h. */
#include "reference/kernels/normals.h"
#include "reference/kernels/order.h"
#include "reference/kernels/points_avx2.h"

#if defined(__x86_64__)

TARGET_AVX2 int64_t face_normals_avx2(const struct mesh *mesh, void *scratch, void *output)
{
    const bool is_scattered = order_is_scattered(mesh);
    const float *positions = mesh->positions;
    const int32_t *t = mesh->triangles;
    float *normal = output;
    int32_t left = mesh->triangle_count;
    for (; left >= 4; left -= 4, t += 12, normal += 12) {
        if (is_scattered && left >= CORNERS_AHEAD + 4)
            for (int k = 0; k < 4; k++)
                prefetch_corners(positions, t + 3 * (CORNERS_AHEAD + k));
        store_units4(normal, load_cross4(positions, t));
    }
    const struct mesh rest = {mesh->positions, mesh->triangles + (t - mesh->triangles),
                              mesh->vertex_count, left};
    face_normals_plain(&rest, scratch, normal);
    return mesh->triangle_count;
}

#endif
