/* The sides that run upwards, eight at a time; see edges_closed.h. */
#include "reference/kernels/edges_closed.h"
#include "reference/kernels/x86.h"

#if defined(__x86_64__)

#include <immintrin.h>

/* Appends those of eight pairs (i,j) whose j is larger. As a 64-bit number a pair is i + 2^32 j, so
 * it then exceeds the pair turned around. All eight are written, and those to keep stepped over. */
TARGET_AVX512 static inline int64_t *put_upwards(__m512i pairs, int64_t *end)
{
    __mmask8 keep = _mm512_cmpgt_epu64_mask(pairs, _mm512_rol_epi64(pairs, 32));
    _mm512_storeu_si512(end, _mm512_maskz_compress_epi64(keep, pairs));
    return end + _mm_popcnt_u32(keep);
}

/* Eight triangles have 24 sides, three vectors. Each is one permutation of 16 indices in a row:
 * they begin at index 0, 6 and 15 of the 24. The last reads 7 indices further than the eight
 * triangles. */
TARGET_AVX512 int64_t edges_closed_avx512(const struct mesh *mesh, void *scratch, void *output)
{
    (void)scratch;
    const __m512i first = _mm512_setr_epi32(0, 1, 1, 2, 2, 0, 3, 4, 4, 5, 5, 3, 6, 7, 7, 8);
    const __m512i second = _mm512_setr_epi32(2, 0, 3, 4, 4, 5, 5, 3, 6, 7, 7, 8, 8, 6, 9, 10);
    const __m512i third = _mm512_setr_epi32(1, 2, 2, 0, 3, 4, 4, 5, 5, 3, 6, 7, 7, 8, 8, 6);
    const int32_t *t = mesh->triangles;
    int64_t *end = output;
    int32_t left = mesh->triangle_count;
    for (; left >= 11; left -= 8, t += 24) {
        end = put_upwards(_mm512_permutexvar_epi32(first, _mm512_loadu_si512(t)), end);
        end = put_upwards(_mm512_permutexvar_epi32(second, _mm512_loadu_si512(t + 6)), end);
        end = put_upwards(_mm512_permutexvar_epi32(third, _mm512_loadu_si512(t + 15)), end);
    }
    const struct mesh rest = {NULL, mesh->triangles + (t - mesh->triangles), 0, left};
    return (end - (int64_t *)output) + edges_closed_plain(&rest, NULL, end);
}

/* Compares the corners with those after them: of 48 indices in a row, the last of each triangle
 * with the one two places before, the others with the one behind. */
TARGET_AVX512 int64_t edges_closed_count_avx512(const int32_t *triangles, int32_t triangle_count)
{
    const uint64_t third_corners = UINT64_C(0x924924924924);
    const int32_t *t = triangles;
    int64_t count = 0;
    int32_t left = triangle_count;
    for (; left >= 17; left -= 16, t += 48) {
        uint64_t below_next = 0, above_first = 0;
        for (int k = 0; k < 48; k += 16) {
            __m512i corner = _mm512_loadu_si512(t + k), next = _mm512_loadu_si512(t + k + 1);
            below_next |= (uint64_t)_mm512_cmplt_epi32_mask(corner, next) << k;
        }
        for (int k = 2; k < 48; k += 16) {
            __m512i third = _mm512_loadu_si512(t + k), first = _mm512_loadu_si512(t + k - 2);
            above_first |= (uint64_t)_mm512_cmplt_epi32_mask(third, first) << k;
        }
        count += _mm_popcnt_u64((below_next & ~third_corners) | (above_first & third_corners));
    }
    return count + edges_closed_count(t, left);
}

#endif
