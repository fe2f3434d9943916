/* Corners of four triangles at a time, in binary64, for the AVX2 variants. */
#ifndef REFERENCE_KERNELS_POINTS_AVX2_H
#define REFERENCE_KERNELS_POINTS_AVX2_H

#include "reference/kernels/x86.h"

#if defined(__x86_64__)

#include <immintrin.h>
#include <stddef.h>
#include <stdint.h>

struct points4 {
    __m256d x, y, z;
};

/* A point and 0; the memory behind it is not read, as the last point of a mesh has none. In two
 * parts, which is faster than vmaskmovps. */
TARGET_AVX2 static inline __m128 load_point4(const float *positions, int32_t vertex)
{
    const float *p = positions + 3 * (size_t)(uint32_t)vertex;
    __m128 xy = _mm_castsi128_ps(_mm_loadl_epi64((const __m128i *)(const void *)p));
    return _mm_insert_ps(xy, _mm_load_ss(p + 2), 0x20);
}

/* Turns four points into their coordinates. */
TARGET_AVX2 static inline struct points4 transpose4(__m128 p0, __m128 p1, __m128 p2, __m128 p3)
{
    __m128 xy01 = _mm_unpacklo_ps(p0, p1), xy23 = _mm_unpacklo_ps(p2, p3);
    __m128 z01 = _mm_unpackhi_ps(p0, p1), z23 = _mm_unpackhi_ps(p2, p3);
    return (struct points4){_mm256_cvtps_pd(_mm_movelh_ps(xy01, xy23)),
                            _mm256_cvtps_pd(_mm_movehl_ps(xy23, xy01)),
                            _mm256_cvtps_pd(_mm_movelh_ps(z01, z23))};
}

/* The points at corner[0], corner[3], corner[6], corner[9]. */
TARGET_AVX2 static inline struct points4 load_corners4(const float *positions,
                                                       const int32_t *corner)
{
    return transpose4(load_point4(positions, corner[0]), load_point4(positions, corner[3]),
                      load_point4(positions, corner[6]), load_point4(positions, corner[9]));
}

TARGET_AVX2 static inline struct points4 points4_minus(struct points4 a, struct points4 b)
{
    return (struct points4){_mm256_sub_pd(a.x, b.x), _mm256_sub_pd(a.y, b.y),
                            _mm256_sub_pd(a.z, b.z)};
}

/* (b - a) x (c - a) for four triangles, each operation rounded as in plain C. */
TARGET_AVX2 static inline struct points4 load_cross4(const float *positions, const int32_t *t)
{
    struct points4 a = load_corners4(positions, t);
    struct points4 u = points4_minus(load_corners4(positions, t + 1), a);
    struct points4 v = points4_minus(load_corners4(positions, t + 2), a);
    return (struct points4){_mm256_sub_pd(_mm256_mul_pd(u.y, v.z), _mm256_mul_pd(u.z, v.y)),
                            _mm256_sub_pd(_mm256_mul_pd(u.z, v.x), _mm256_mul_pd(u.x, v.z)),
                            _mm256_sub_pd(_mm256_mul_pd(u.x, v.y), _mm256_mul_pd(u.y, v.x))};
}

TARGET_AVX2 static inline __m256d squared_length4(struct points4 p)
{
    return _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(p.x, p.x), _mm256_mul_pd(p.y, p.y)),
                         _mm256_mul_pd(p.z, p.z));
}

/* Writes four points of length 1, or 0 where the length is 0, as 12 floats. */
TARGET_AVX2 static inline void store_units4(float *to, struct points4 p)
{
    __m256d squared = squared_length4(p);
    __m256d is_positive = _mm256_cmp_pd(squared, _mm256_setzero_pd(), _CMP_GT_OQ);
    __m256d inverse = _mm256_div_pd(_mm256_set1_pd(1), _mm256_sqrt_pd(squared));
    __m256d scale = _mm256_and_pd(is_positive, inverse);
    __m128 x = _mm256_cvtpd_ps(_mm256_mul_pd(p.x, scale));
    __m128 y = _mm256_cvtpd_ps(_mm256_mul_pd(p.y, scale));
    __m128 z = _mm256_cvtpd_ps(_mm256_mul_pd(p.z, scale));
    __m128 xy01 = _mm_unpacklo_ps(x, y), xy23 = _mm_unpackhi_ps(x, y);
    __m128 z0x1 = _mm_shuffle_ps(z, x, _MM_SHUFFLE(1, 1, 0, 0));
    __m128 y1z1 = _mm_shuffle_ps(y, z, _MM_SHUFFLE(1, 1, 1, 1));
    __m128 z2x3 = _mm_shuffle_ps(z, x, _MM_SHUFFLE(3, 3, 2, 2));
    __m128 y3z3 = _mm_shuffle_ps(y, z, _MM_SHUFFLE(3, 3, 3, 3));
    _mm_storeu_ps(to, _mm_shuffle_ps(xy01, z0x1, _MM_SHUFFLE(2, 0, 1, 0)));
    _mm_storeu_ps(to + 4, _mm_shuffle_ps(y1z1, xy23, _MM_SHUFFLE(1, 0, 2, 0)));
    _mm_storeu_ps(to + 8, _mm_shuffle_ps(z2x3, y3z3, _MM_SHUFFLE(2, 0, 2, 0)));
}

#endif
#endif
