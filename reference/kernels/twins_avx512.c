/* Twins: rows are matched a storey at a time; see twins.h. */
#include "reference/kernels/side_rows.h"
#include "reference/kernels/twin_pairs.h"
#include "reference/kernels/twins.h"
#include "reference/kernels/x86.h"

#if defined(__x86_64__)

#include <immintrin.h>

/* Pairs the sides in a first storey. vpconflict names for each place the places before it with the
 * same neighbour: one in a manifold, and the side there must run the other way. Returns false, with
 * nothing entered, when that is not so. */
TARGET_AVX512 static inline bool match_storey(const struct storey *storey, unsigned count,
                                              int32_t vertex, struct twin_pairs *pairs)
{
    __m512i places = _mm512_load_si512(storey);
    __m256i neighbours = _mm512_cvtepi64_epi32(places);
    __m256i sides = _mm512_cvtepi64_epi32(_mm512_srli_epi64(places, 32));
    __mmask8 used = (__mmask8)((1U << count) - 1);
    __m256i before = _mm256_maskz_conflict_epi32(used, neighbours);
    __mmask8 second = _mm256_test_epi32_mask(before, before);
    __m256i more = _mm256_and_si256(before, _mm256_sub_epi32(before, _mm256_set1_epi32(1)));
    __m256i place = _mm256_sub_epi32(_mm256_set1_epi32(31), _mm256_lzcnt_epi32(before));
    __m256i met = _mm256_permutevar8x32_epi32(sides, place);
    __mmask8 opposite = _mm256_movepi32_mask(_mm256_xor_si256(met, sides));
    __mmask8 self = _mm256_mask_cmpeq_epi32_mask(used, neighbours, _mm256_set1_epi32(vertex));
    if ((second & ~opposite) | self | _mm256_test_epi32_mask(more, more))
        return false;
    const __m256i number = _mm256_set1_epi32(INT32_MAX);
    _mm256_storeu_si256((__m256i *)(pairs->one + pairs->count),
                        _mm256_maskz_compress_epi32(second, _mm256_and_si256(sides, number)));
    _mm256_storeu_si256((__m256i *)(pairs->other + pairs->count),
                        _mm256_maskz_compress_epi32(second, _mm256_and_si256(met, number)));
    pairs->count += (size_t)_mm_popcnt_u32(second);
    return true;
}

/* The same for a row of two storeys. */
TARGET_AVX512 static inline bool match_both(const struct storey *lower, const struct storey *upper,
                                            unsigned count, int32_t vertex,
                                            struct twin_pairs *pairs)
{
    __m512i low = _mm512_load_si512(lower), high = _mm512_load_si512(upper);
    const __m512i even =
        _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    const __m512i odd =
        _mm512_setr_epi32(1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31);
    __m512i neighbours = _mm512_permutex2var_epi32(low, even, high);
    __m512i sides = _mm512_permutex2var_epi32(low, odd, high);
    __mmask16 used = (__mmask16)((1U << count) - 1);
    __m512i before = _mm512_maskz_conflict_epi32(used, neighbours);
    __mmask16 second = _mm512_test_epi32_mask(before, before);
    __m512i more = _mm512_and_si512(before, _mm512_sub_epi32(before, _mm512_set1_epi32(1)));
    __m512i place = _mm512_sub_epi32(_mm512_set1_epi32(31), _mm512_lzcnt_epi32(before));
    __m512i met = _mm512_permutexvar_epi32(place, sides);
    __mmask16 opposite = _mm512_movepi32_mask(_mm512_xor_si512(met, sides));
    __mmask16 self = _mm512_mask_cmpeq_epi32_mask(used, neighbours, _mm512_set1_epi32(vertex));
    if ((second & ~opposite) | self | _mm512_test_epi32_mask(more, more))
        return false;
    const __m512i number = _mm512_set1_epi32(INT32_MAX);
    _mm512_storeu_si512(pairs->one + pairs->count,
                        _mm512_maskz_compress_epi32(second, _mm512_and_si512(sides, number)));
    _mm512_storeu_si512(pairs->other + pairs->count,
                        _mm512_maskz_compress_epi32(second, _mm512_and_si512(met, number)));
    pairs->count += (size_t)_mm_popcnt_u32(second);
    return true;
}

TARGET_AVX512 static inline bool match_row(const struct side_rows *rows, int32_t row,
                                           struct twin_pairs *pairs)
{
    unsigned count = rows->counts[row];
    int32_t v = rows->first_vertex + row;
    const struct storey *lower = rows->storeys + row;
    if (count <= STOREY_PLACES)
        return match_storey(lower, count, v, pairs);
    if (count <= SIDE_ROW_PLACES)
        return match_both(lower, lower + rows->row_count, count, v, pairs);
    return true;
}

TARGET_AVX512 void twins_match_avx512(const struct side_rows *rows, int32_t begin, int32_t end,
                                      int32_t *twin)
{
    struct twin_pairs pairs = {.twin = twin};
    for (int32_t row = begin; row < end; row++) {
        if (!match_row(rows, row, &pairs))
            side_rows_match_carefully(rows, row, twin);
        if (pairs.count >= TWIN_PAIRS)
            twin_pairs_flush(&pairs);
    }
    twin_pairs_flush(&pairs);
}

int64_t twins_avx512(const struct mesh *mesh, void *scratch, void *output)
{
    return twins_by(side_rows_of_avx512, twins_match_avx512, mesh, scratch, output);
}

#endif
