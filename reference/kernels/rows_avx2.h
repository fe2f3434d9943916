/* Repeated neighbours in rows of eight and sixteen, for the AVX2 variants: what vpconflict does for
 * AVX-512, by comparing a row with itself turned by 1 ... 7 places. */
#ifndef REFERENCE_KERNELS_ROWS_AVX2_H
#define REFERENCE_KERNELS_ROWS_AVX2_H

#include "reference/kernels/x86.h"

#if defined(__x86_64__)

#include <immintrin.h>
#include <stdint.h>

TARGET_AVX2 static inline __m256i places8(void)
{
    return _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
}

/* How often each of eight neighbours was met before, and what was with it then: of several, any. */
struct met8 {
    __m256i times, sides;
};

/* Meets the neighbours in the eight places before, turned by k; only those places count that then
 * stand before the own one. */
TARGET_AVX2 static inline struct met8 meet_before(struct met8 met, __m256i neighbours,
                                                  __m256i sides, int k)
{
    __m256i from = _mm256_sub_epi32(places8(), _mm256_set1_epi32(k));
    __m256i equal = _mm256_cmpeq_epi32(neighbours, _mm256_permutevar8x32_epi32(neighbours, from));
    equal = _mm256_andnot_si256(_mm256_srai_epi32(from, 31), equal);
    __m256i turned = _mm256_permutevar8x32_epi32(sides, from);
    return (struct met8){_mm256_sub_epi32(met.times, equal),
                         _mm256_blendv_epi8(met.sides, turned, equal)};
}

TARGET_AVX2 static inline struct met8 meet_within(__m256i neighbours, __m256i sides)
{
    struct met8 met = {_mm256_setzero_si256(), sides};
    for (int k = 1; k < 8; k++)
        met = meet_before(met, neighbours, sides, k);
    return met;
}

/* Meets all of the eight places before these eight. */
TARGET_AVX2 static inline struct met8 meet_lower(struct met8 met, __m256i neighbours, __m256i lower,
                                                 __m256i lower_sides)
{
    for (int k = 0; k < 8; k++) {
        __m256i from = _mm256_add_epi32(places8(), _mm256_set1_epi32(k));
        __m256i equal = _mm256_cmpeq_epi32(neighbours, _mm256_permutevar8x32_epi32(lower, from));
        __m256i turned = _mm256_permutevar8x32_epi32(lower_sides, from);
        met.times = _mm256_sub_epi32(met.times, equal);
        met.sides = _mm256_blendv_epi8(met.sides, turned, equal);
    }
    return met;
}

/* A bit for each of the eight whose sign is set. */
TARGET_AVX2 static inline unsigned signs8(__m256i v)
{
    return (unsigned)_mm256_movemask_ps(_mm256_castsi256_ps(v));
}

/* The first `count` places, count >= 0, as signs. */
TARGET_AVX2 static inline __m256i first_places(int count)
{
    return _mm256_cmpgt_epi32(_mm256_set1_epi32(count), places8());
}

/* The permutation that moves the chosen places to the front. */
TARGET_AVX2 static inline __m256i to_front8(unsigned chosen)
{
    uint64_t bytes = _pdep_u64(chosen, UINT64_C(0x0101010101010101)) * 0xFF;
    uint64_t places = _pext_u64(UINT64_C(0x0706050403020100), bytes);
    return _mm256_cvtepu8_epi32(_mm_cvtsi64_si128((long long)places));
}

#endif
#endif
