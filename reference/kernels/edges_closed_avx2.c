/* The sides that run upwards, four at a time; see edges_closed.h. */
#include "reference/kernels/edges_closed.h"
#include "reference/kernels/x86.h"

#if defined(__x86_64__)

#include <immintrin.h>

/* For each set of pairs to keep among four, the permutation that moves them to the front. */
static const int32_t to_front[16][8] __attribute__((aligned(32))) = {
    {0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, {2, 3, 0, 1, 4, 5, 6, 7},
    {0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 0, 1, 2, 3, 6, 7}, {0, 1, 4, 5, 2, 3, 6, 7},
    {2, 3, 4, 5, 0, 1, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, {6, 7, 0, 1, 2, 3, 4, 5},
    {0, 1, 6, 7, 2, 3, 4, 5}, {2, 3, 6, 7, 0, 1, 4, 5}, {0, 1, 2, 3, 6, 7, 4, 5},
    {4, 5, 6, 7, 0, 1, 2, 3}, {0, 1, 4, 5, 6, 7, 2, 3}, {2, 3, 4, 5, 6, 7, 0, 1},
    {0, 1, 2, 3, 4, 5, 6, 7}};

/* Appends those of four pairs (i,j) whose j is larger. */
TARGET_AVX2 static inline int64_t *put_upwards(__m256i pairs, int64_t *end)
{
    __m256i turned = _mm256_shuffle_epi32(pairs, 0xB1);
    int keep = _mm256_movemask_pd(_mm256_castsi256_pd(_mm256_cmpgt_epi32(pairs, turned)));
    __m256i order = _mm256_load_si256((const __m256i *)to_front[keep]);
    _mm256_storeu_si256((__m256i *)end, _mm256_permutevar8x32_epi32(pairs, order));
    return end + _mm_popcnt_u32((unsigned)keep);
}

TARGET_AVX2 static inline __m256i permuted(const int32_t *indices, __m256i order)
{
    return _mm256_permutevar8x32_epi32(_mm256_loadu_si256((const __m256i *)indices), order);
}

/* Four triangles have 12 sides, three vectors. Each is one permutation of 8 indices in a row: they
 * begin at index 0, 3 and 6 of the 12. The last reads 2 indices further than the four triangles. */
TARGET_AVX2 int64_t edges_closed_avx2(const struct mesh *mesh, void *scratch, void *output)
{
    (void)scratch;
    const __m256i first = _mm256_setr_epi32(0, 1, 1, 2, 2, 0, 3, 4);
    const __m256i second = _mm256_setr_epi32(1, 2, 2, 0, 3, 4, 4, 5);
    const __m256i third = _mm256_setr_epi32(2, 0, 3, 4, 4, 5, 5, 3);
    const int32_t *t = mesh->triangles;
    int64_t *end = output;
    int32_t left = mesh->triangle_count;
    for (; left >= 5; left -= 4, t += 12) {
        end = put_upwards(permuted(t, first), end);
        end = put_upwards(permuted(t + 3, second), end);
        end = put_upwards(permuted(t + 6, third), end);
    }
    const struct mesh rest = {NULL, mesh->triangles + (t - mesh->triangles), 0, left};
    return (end - (int64_t *)output) + edges_closed_plain(&rest, NULL, end);
}

/* Compares eight corners with the ones behind, and with the ones two places before. */
TARGET_AVX2 static inline uint64_t upward8(const int32_t *t, int first_third)
{
    __m256i corner = _mm256_loadu_si256((const __m256i *)t);
    __m256i next = _mm256_loadu_si256((const __m256i *)(t + 1));
    __m256i third = _mm256_loadu_si256((const __m256i *)(t + first_third));
    __m256i first = _mm256_loadu_si256((const __m256i *)(t + first_third - 2));
    __m256i below = _mm256_cmpgt_epi32(next, corner), above = _mm256_cmpgt_epi32(first, third);
    unsigned below_next = (unsigned)_mm256_movemask_ps(_mm256_castsi256_ps(below));
    unsigned above_first = (unsigned)_mm256_movemask_ps(_mm256_castsi256_ps(above));
    unsigned thirds = 0x249249U << first_third & 0xFF, among = 0x49U & 0xFFU >> first_third;
    return (uint64_t)_mm_popcnt_u32(below_next & ~thirds) +
           (uint64_t)_mm_popcnt_u32(above_first & among);
}

/* Twenty-four corners at a time; those in eighths begin with a first, a third and a second one. */
TARGET_AVX2 int64_t edges_closed_count_avx2(const int32_t *triangles, int32_t triangle_count)
{
    const int32_t *t = triangles;
    uint64_t count = 0;
    int32_t left = triangle_count;
    for (; left >= 9; left -= 8, t += 24)
        count += upward8(t, 2) + upward8(t + 8, 0) + upward8(t + 16, 1);
    return (int64_t)count + edges_closed_count(t, left);
}

#endif
