/* Edge table of any mesh: rows are read a vector at a time; see edges_any.h. */
#include "reference/kernels/edges_any.h"
#include "reference/kernels/neighbour_rows.h"
#include "reference/kernels/rows_avx2.h"

#if defined(__x86_64__)

/* Writes the pairs (vertex, neighbour) of the neighbours to keep among eight. */
TARGET_AVX2 static inline int64_t *put_pairs(__m256i neighbours, unsigned keep, int32_t vertex,
                                             int64_t *end)
{
    __m256i kept = _mm256_permutevar8x32_epi32(neighbours, to_front8(keep));
    __m256i vertices = _mm256_set1_epi64x(vertex);
    __m256i low = _mm256_cvtepu32_epi64(_mm256_castsi256_si128(kept));
    __m256i high = _mm256_cvtepu32_epi64(_mm256_extracti128_si256(kept, 1));
    low = _mm256_or_si256(_mm256_slli_epi64(low, 32), vertices);
    high = _mm256_or_si256(_mm256_slli_epi64(high, 32), vertices);
    _mm256_storeu_si256((__m256i *)end, low);
    _mm256_storeu_si256((__m256i *)(end + 4), high);
    return end + _mm_popcnt_u32(keep);
}

/* The places among the first `count` that hold a neighbour not met before and not the vertex. */
TARGET_AVX2 static inline unsigned new_ones(__m256i neighbours, __m256i times, int count,
                                            int32_t vertex)
{
    __m256i drop = _mm256_or_si256(_mm256_cmpgt_epi32(times, _mm256_setzero_si256()),
                                   _mm256_cmpeq_epi32(neighbours, _mm256_set1_epi32(vertex)));
    return signs8(_mm256_andnot_si256(drop, first_places(count)));
}

TARGET_AVX2 static inline int64_t *put_row(const int32_t *place, int count, int32_t vertex,
                                           int64_t *end)
{
    __m256i low = _mm256_load_si256((const __m256i *)place);
    struct met8 met = meet_within(low, low);
    end = put_pairs(low, new_ones(low, met.times, count, vertex), vertex, end);
    if (count <= 8)
        return end;
    __m256i high = _mm256_load_si256((const __m256i *)(place + 8));
    met = meet_lower(meet_within(high, high), high, low, low);
    return put_pairs(high, new_ones(high, met.times, count - 8, vertex), vertex, end);
}

TARGET_AVX2 int32_t *neighbour_rows_put_edges_avx2(const struct neighbour_rows *rows, int32_t begin,
                                                   int32_t stop, int32_t *edges)
{
    int64_t *end = (int64_t *)(void *)edges;
    for (int32_t v = begin; v < stop; v++) {
        const int32_t *place = neighbour_row(rows, v);
        int count = *neighbour_row_count(rows, v);
        if (count <= ROW_PLACES)
            end = put_row(place, count, v, end);
        else
            end = (int64_t *)(void *)neighbour_rows_put_overflow(rows, v, (int32_t *)(void *)end);
    }
    return (int32_t *)(void *)end;
}

int64_t edges_any_avx2(const struct mesh *mesh, void *scratch, void *output)
{
    return edges_any_by(neighbour_rows_put_edges_avx2, mesh, scratch, output);
}

#endif
