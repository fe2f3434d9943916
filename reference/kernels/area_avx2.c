/* Area, four triangles at a time; see area.h. */
#include "reference/kernels/area.h"
#include "reference/kernels/order.h"
#include "reference/kernels/points_avx2.h"

#if defined(__x86_64__)

TARGET_AVX2 int64_t area_avx2(const struct mesh *mesh, void *scratch, void *output)
{
    (void)scratch;
    const bool is_scattered = order_is_scattered(mesh);
    const float *positions = mesh->positions;
    const int32_t *t = mesh->triangles;
    __m256d sums = _mm256_setzero_pd();
    int32_t left = mesh->triangle_count;
    for (; left >= 4; left -= 4, t += 12) {
        if (is_scattered && left >= CORNERS_AHEAD + 4)
            for (int k = 0; k < 4; k++)
                prefetch_corners(positions, t + 3 * (CORNERS_AHEAD + k));
        __m256d squared = squared_length4(load_cross4(positions, t));
        sums = _mm256_add_pd(sums, _mm256_sqrt_pd(squared));
    }
    const struct mesh rest = {mesh->positions, mesh->triangles + (t - mesh->triangles),
                              mesh->vertex_count, left};
    area_plain(&rest, NULL, output);
    double sum[4];
    _mm256_storeu_pd(sum, sums);
    *(double *)output += 0.5 * ((sum[0] + sum[1]) + (sum[2] + sum[3]));
    return 1;
}

#endif
