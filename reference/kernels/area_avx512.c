/* Area, eight triangles at a time; see area.h. */
#include "reference/kernels/area.h"
#include "reference/kernels/order.h"
#include "reference/kernels/points_avx512.h"

#if defined(__x86_64__)

TARGET_AVX512 int64_t area_avx512(const struct mesh *mesh, void *scratch, void *output)
{
    (void)scratch;
    enum { AHEAD = 24 };
    const float *positions = mesh->positions;
    const int32_t *t = mesh->triangles;
    __m512d sums = _mm512_setzero_pd();
    int32_t left = mesh->triangle_count;
    if (order_is_scattered(mesh))
        for (; left >= AHEAD + 8; left -= 8, t += 24) {
            prefetch_corners8(positions, t + 3 * AHEAD);
            __m512d squared = squared_length8(load_cross8(positions, t));
            sums = _mm512_add_pd(sums, _mm512_sqrt_pd(squared));
        }
    for (; left >= 8; left -= 8, t += 24) {
        __m512d squared = squared_length8(load_cross8(positions, t));
        sums = _mm512_add_pd(sums, _mm512_sqrt_pd(squared));
    }
    const struct mesh rest = {mesh->positions, mesh->triangles + (t - mesh->triangles),
                              mesh->vertex_count, left};
    area_plain(&rest, NULL, output);
    *(double *)output += 0.5 * _mm512_reduce_add_pd(sums);
    return 1;
}

#endif
