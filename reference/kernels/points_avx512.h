/* Corners of eight triangles at a time, in binary64, for the AVX-512 variants. */
#ifndef REFERENCE_KERNELS_POINTS_AVX512_H
#define REFERENCE_KERNELS_POINTS_AVX512_H

#include "reference/kernels/x86.h"

#if defined(__x86_64__)

#include <immintrin.h>
#include <stddef.h>
#include <stdint.h>

struct points8 {
    __m512d x, y, z;
};

/* Two points; the fourth float of each half is 0 and its memory is not read, as the last point of
 * a mesh has none behind it. */
TARGET_AVX512 static inline __m256 load_two_points(const float *low, const float *high)
{
    __m256 both = _mm256_castps128_ps256(_mm_maskz_loadu_ps(7, low));
    return _mm256_insertf32x4(both, _mm_maskz_loadu_ps(7, high), 1);
}

/* Turns points 0 4, 1 5, 2 6, 3 7 into their coordinates. */
TARGET_AVX512 static inline struct points8 transpose8(__m256 p04, __m256 p15, __m256 p26,
                                                      __m256 p37)
{
    __m256d xy01 = _mm256_castps_pd(_mm256_unpacklo_ps(p04, p15));
    __m256d xy23 = _mm256_castps_pd(_mm256_unpacklo_ps(p26, p37));
    __m256d z01 = _mm256_castps_pd(_mm256_unpackhi_ps(p04, p15));
    __m256d z23 = _mm256_castps_pd(_mm256_unpackhi_ps(p26, p37));
    return (struct points8){_mm512_cvtps_pd(_mm256_castpd_ps(_mm256_unpacklo_pd(xy01, xy23))),
                            _mm512_cvtps_pd(_mm256_castpd_ps(_mm256_unpackhi_pd(xy01, xy23))),
                            _mm512_cvtps_pd(_mm256_castpd_ps(_mm256_unpacklo_pd(z01, z23)))};
}

/* The points at corner[0], corner[3], ... corner[21]. Eight masked loads and shuffles take half the
 * time of three gathers. */
TARGET_AVX512 static inline struct points8 load_corners8(const float *positions,
                                                         const int32_t *corner)
{
    const float *p[8];
    for (int k = 0; k < 8; k++)
        p[k] = positions + 3 * (size_t)(uint32_t)corner[3 * k];
    return transpose8(load_two_points(p[0], p[4]), load_two_points(p[1], p[5]),
                      load_two_points(p[2], p[6]), load_two_points(p[3], p[7]));
}

TARGET_AVX512 static inline struct points8 points8_minus(struct points8 a, struct points8 b)
{
    return (struct points8){_mm512_sub_pd(a.x, b.x), _mm512_sub_pd(a.y, b.y),
                            _mm512_sub_pd(a.z, b.z)};
}

/* (b - a) x (c - a) for eight triangles, each operation rounded as in plain C. */
TARGET_AVX512 static inline struct points8 load_cross8(const float *positions, const int32_t *t)
{
    struct points8 a = load_corners8(positions, t);
    struct points8 u = points8_minus(load_corners8(positions, t + 1), a);
    struct points8 v = points8_minus(load_corners8(positions, t + 2), a);
    return (struct points8){_mm512_sub_pd(_mm512_mul_pd(u.y, v.z), _mm512_mul_pd(u.z, v.y)),
                            _mm512_sub_pd(_mm512_mul_pd(u.z, v.x), _mm512_mul_pd(u.x, v.z)),
                            _mm512_sub_pd(_mm512_mul_pd(u.x, v.y), _mm512_mul_pd(u.y, v.x))};
}

TARGET_AVX512 static inline __m512d squared_length8(struct points8 p)
{
    return _mm512_add_pd(_mm512_add_pd(_mm512_mul_pd(p.x, p.x), _mm512_mul_pd(p.y, p.y)),
                         _mm512_mul_pd(p.z, p.z));
}

/* Writes eight points of length 1, or 0 where the length is 0, as 24 floats. */
TARGET_AVX512 static inline void store_units8(float *to, struct points8 p)
{
    const __m512i front = _mm512_setr_epi32(0, 8, 16, 1, 9, 17, 2, 10, 18, 3, 11, 19, 4, 12, 20, 5);
    const __m512i back = _mm512_setr_epi32(13, 21, 6, 14, 22, 7, 15, 23, 0, 0, 0, 0, 0, 0, 0, 0);
    __m512d squared = squared_length8(p), zero = _mm512_setzero_pd();
    __mmask8 is_positive = _mm512_cmp_pd_mask(squared, zero, _CMP_GT_OQ);
    __m512d scale = _mm512_maskz_div_pd(is_positive, _mm512_set1_pd(1), _mm512_sqrt_pd(squared));
    __m256 x = _mm512_cvtpd_ps(_mm512_mul_pd(p.x, scale));
    __m256 y = _mm512_cvtpd_ps(_mm512_mul_pd(p.y, scale));
    __m256 z = _mm512_cvtpd_ps(_mm512_mul_pd(p.z, scale));
    __m512 xy = _mm512_insertf32x8(_mm512_castps256_ps512(x), y, 1);
    __m512 zz = _mm512_castps256_ps512(z);
    _mm512_storeu_ps(to, _mm512_permutex2var_ps(xy, front, zz));
    _mm256_storeu_ps(to + 16, _mm512_castps512_ps256(_mm512_permutex2var_ps(xy, back, zz)));
}

/* Asks for the corners of the eight triangles at t. */
TARGET_AVX512 static inline void prefetch_corners8(const float *positions, const int32_t *t)
{
    for (int k = 0; k < 24; k++)
        __builtin_prefetch(positions + 3 * (size_t)(uint32_t)t[k]);
}

#endif
#endif
