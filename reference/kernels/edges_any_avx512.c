/* Edge table of any mesh: rows are read a vector at a time; see edges_any.h. */
#include "reference/kernels/edges_any.h"
#include "reference/kernels/neighbour_rows.h"
#include "reference/kernels/x86.h"

#if defined(__x86_64__)

#include <immintrin.h>

/* Writes the pairs (vertex, neighbour) of the neighbours to keep among eight. */
TARGET_AVX512 static inline int64_t *put_pairs(__m256i neighbours, __mmask8 keep, int32_t vertex,
                                               int64_t *end)
{
    __m512i wide = _mm512_cvtepu32_epi64(_mm256_maskz_compress_epi32(keep, neighbours));
    __m512i pairs = _mm512_or_si512(_mm512_slli_epi64(wide, 32), _mm512_set1_epi64(vertex));
    _mm512_storeu_si512(end, pairs);
    return end + _mm_popcnt_u32(keep);
}

/* vpconflict names for each place the places before it that hold the same. What lies behind the
 * count of a row is left over from before, and comes after all that counts. */
TARGET_AVX512 int32_t *neighbour_rows_put_edges_avx512(const struct neighbour_rows *rows,
                                                       int32_t begin, int32_t stop, int32_t *edges)
{
    int64_t *end = (int64_t *)(void *)edges;
    for (int32_t v = begin; v < stop; v++) {
        const int32_t *place = neighbour_row(rows, v);
        unsigned count = *neighbour_row_count(rows, v);
        if (count <= 8) {
            __m256i row = _mm256_load_si256((const __m256i *)place);
            __mmask8 first =
                _mm256_testn_epi32_mask(_mm256_conflict_epi32(row), _mm256_set1_epi32(-1));
            __mmask8 other = _mm256_cmpneq_epi32_mask(row, _mm256_set1_epi32(v));
            end = put_pairs(row, first & other & (__mmask8)((1U << count) - 1), v, end);
        } else if (count <= ROW_PLACES) {
            __m512i row = _mm512_load_si512(place);
            __mmask16 first =
                _mm512_testn_epi32_mask(_mm512_conflict_epi32(row), _mm512_set1_epi32(-1));
            __mmask16 other = _mm512_cmpneq_epi32_mask(row, _mm512_set1_epi32(v));
            unsigned keep = first & other & ((1U << count) - 1);
            end = put_pairs(_mm512_castsi512_si256(row), (__mmask8)keep, v, end);
            end = put_pairs(_mm512_extracti64x4_epi64(row, 1), (__mmask8)(keep >> 8), v, end);
        } else {
            end = (int64_t *)(void *)neighbour_rows_put_overflow(rows, v, (int32_t *)(void *)end);
        }
    }
    return (int32_t *)(void *)end;
}

int64_t edges_any_avx512(const struct mesh *mesh, void *scratch, void *output)
{
    return edges_any_by(neighbour_rows_put_edges_avx512, mesh, scratch, output);
}

#endif
