/* A normal for each vertex, weighted by area; see normals.h. Sums are four floats wide: nothing
 * here would gain by longer vectors. */
#include "reference/kernels/normals.h"
#include "reference/kernels/order.h"
#include "reference/kernels/points_avx2.h"

#if defined(__x86_64__)

#include <string.h>

TARGET_AVX2 static inline void add_to(float *sums, int32_t vertex, __m128 cross)
{
    float *sum = sums + 4 * (size_t)(uint32_t)vertex;
    _mm_store_ps(sum, _mm_add_ps(_mm_load_ps(sum), cross));
}

/* The products u v' - u' v, where ' turns x y z into y z x, are the cross product as z x y. */
TARGET_AVX2 static inline void add_triangle(const float *positions, const int32_t t[3], float *sums)
{
    enum { YZX = _MM_SHUFFLE(3, 0, 2, 1) };
    __m128 a = load_point4(positions, t[0]);
    __m128 u = _mm_sub_ps(load_point4(positions, t[1]), a);
    __m128 v = _mm_sub_ps(load_point4(positions, t[2]), a);
    __m128 zxy =
        _mm_sub_ps(_mm_mul_ps(u, _mm_permute_ps(v, YZX)), _mm_mul_ps(_mm_permute_ps(u, YZX), v));
    __m128 cross = _mm_permute_ps(zxy, YZX);
    add_to(sums, t[0], cross);
    add_to(sums, t[1], cross);
    add_to(sums, t[2], cross);
}

TARGET_AVX2 static void add_triangles(const struct mesh *mesh, float *sums)
{
    const bool is_scattered = order_is_scattered(mesh);
    const float *positions = mesh->positions;
    const int32_t *t = mesh->triangles;
    for (int32_t left = mesh->triangle_count; left > 0; left--, t += 3) {
        if (is_scattered && left > CORNERS_AHEAD) {
            prefetch_corners(positions, t + 3 * CORNERS_AHEAD);
            for (int k = 3 * CORNERS_AHEAD; k < 3 * CORNERS_AHEAD + 3; k++)
                __builtin_prefetch(sums + 4 * (size_t)(uint32_t)t[k], 1);
        }
        add_triangle(positions, t, sums);
    }
}

TARGET_AVX2 int64_t vertex_normals_avx2(const struct mesh *mesh, void *scratch, void *output)
{
    float *sums = scratch, *normals = output;
    size_t v = 0, vertex_count = (size_t)mesh->vertex_count;
    memset(sums, 0, 16 * vertex_count);
    add_triangles(mesh, sums);
    for (; v + 4 <= vertex_count; v += 4) {
        const float *s = sums + 4 * v;
        store_units4(normals + 3 * v, transpose4(_mm_load_ps(s), _mm_load_ps(s + 4),
                                                 _mm_load_ps(s + 8), _mm_load_ps(s + 12)));
    }
    for (; v < vertex_count; v++)
        vertex_normal_write(sums + 4 * v, normals + 3 * v);
    return mesh->vertex_count;
}

#endif
