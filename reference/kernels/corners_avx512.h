/* Sixteen triangles at a time for the AVX-512 variants. */
#ifndef REFERENCE_KERNELS_CORNERS_AVX512_H
#define REFERENCE_KERNELS_CORNERS_AVX512_H

#include "reference/kernels/x86.h"

#if defined(__x86_64__)

#include <immintrin.h>
#include <stdint.h>

/* The first, second and third corners of sixteen triangles. */
struct corners16 {
    __m512i x, y, z;
};

/* Three vectors hold x0 y0 z0 x1 ...; what the third one adds to the picks from the first two has
 * the places 16 and more. */
TARGET_AVX512 static inline struct corners16 load_corners16(const int32_t *triangles)
{
    const __m512i x01 = _mm512_setr_epi32(0, 3, 6, 9, 12, 15, 18, 21, 24, 27, 30, 0, 0, 0, 0, 0);
    const __m512i x2 = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 17, 20, 23, 26, 29);
    const __m512i y01 = _mm512_setr_epi32(1, 4, 7, 10, 13, 16, 19, 22, 25, 28, 31, 0, 0, 0, 0, 0);
    const __m512i y2 = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 18, 21, 24, 27, 30);
    const __m512i z01 = _mm512_setr_epi32(2, 5, 8, 11, 14, 17, 20, 23, 26, 29, 0, 0, 0, 0, 0, 0);
    const __m512i z2 = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 16, 19, 22, 25, 28, 31);
    __m512i v0 = _mm512_loadu_si512(triangles), v1 = _mm512_loadu_si512(triangles + 16);
    __m512i v2 = _mm512_loadu_si512(triangles + 32);
    return (struct corners16){
        _mm512_permutex2var_epi32(_mm512_permutex2var_epi32(v0, x01, v1), x2, v2),
        _mm512_permutex2var_epi32(_mm512_permutex2var_epi32(v0, y01, v1), y2, v2),
        _mm512_permutex2var_epi32(_mm512_permutex2var_epi32(v0, z01, v1), z2, v2)};
}

/* Stores sixteen 64-bit numbers, given as their lower and upper halves. */
TARGET_AVX512 static inline void store_halves16(uint64_t to[16], __m512i lower, __m512i upper)
{
    const __m512i front = _mm512_setr_epi32(0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
    const __m512i back =
        _mm512_setr_epi32(8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);
    _mm512_store_si512(to, _mm512_permutex2var_epi32(lower, front, upper));
    _mm512_store_si512(to + 8, _mm512_permutex2var_epi32(lower, back, upper));
}

#endif
#endif
