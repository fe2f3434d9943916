/* Twins: rows are matched a storey at a time; see twins.h. */
#include "reference/kernels/rows_avx2.h"
#include "reference/kernels/side_rows.h"
#include "reference/kernels/twin_pairs.h"
#include "reference/kernels/twins.h"

#if defined(__x86_64__)

struct eight_sides {
    __m256i neighbours, sides;
};

TARGET_AVX2 static inline struct eight_sides load_storey(const struct storey *storey)
{
    __m256 low = _mm256_loadu_ps((const float *)(const void *)storey->places);
    __m256 high = _mm256_loadu_ps((const float *)(const void *)(storey->places + 4));
    __m256i neighbours = _mm256_castps_si256(_mm256_shuffle_ps(low, high, _MM_SHUFFLE(2, 0, 2, 0)));
    __m256i sides = _mm256_castps_si256(_mm256_shuffle_ps(low, high, _MM_SHUFFLE(3, 1, 3, 1)));
    enum { IN_ORDER = _MM_SHUFFLE(3, 1, 2, 0) };
    return (struct eight_sides){_mm256_permute4x64_epi64(neighbours, IN_ORDER),
                                _mm256_permute4x64_epi64(sides, IN_ORDER)};
}

/* Whether the first `count` of eight sides are those of a coherent manifold: a neighbour was met at
 * most once before, by a side that runs the other way, and is not the vertex itself. */
TARGET_AVX2 static inline bool is_plain(struct eight_sides s, struct met8 met, int count,
                                        int32_t vertex)
{
    __m256i same_way = _mm256_andnot_si256(_mm256_xor_si256(s.sides, met.sides),
                                           _mm256_cmpgt_epi32(met.times, _mm256_setzero_si256()));
    __m256i odd = _mm256_or_si256(
        _mm256_cmpgt_epi32(met.times, _mm256_set1_epi32(1)),
        _mm256_or_si256(same_way, _mm256_cmpeq_epi32(s.neighbours, _mm256_set1_epi32(vertex))));
    return signs8(_mm256_and_si256(odd, first_places(count))) == 0;
}

TARGET_AVX2 static inline void put_pairs(struct eight_sides s, struct met8 met, int count,
                                         struct twin_pairs *pairs)
{
    __m256i second = _mm256_cmpgt_epi32(met.times, _mm256_setzero_si256());
    unsigned chosen = signs8(_mm256_and_si256(second, first_places(count)));
    __m256i order = to_front8(chosen), number = _mm256_set1_epi32(INT32_MAX);
    __m256i one = _mm256_and_si256(_mm256_permutevar8x32_epi32(s.sides, order), number);
    __m256i other = _mm256_and_si256(_mm256_permutevar8x32_epi32(met.sides, order), number);
    _mm256_storeu_si256((__m256i *)(pairs->one + pairs->count), one);
    _mm256_storeu_si256((__m256i *)(pairs->other + pairs->count), other);
    pairs->count += (size_t)_mm_popcnt_u32(chosen);
}

/* Pairs the sides of a row. Returns false, with nothing entered, when it takes more care. */
TARGET_AVX2 static inline bool match_row(const struct side_rows *rows, int32_t row,
                                         struct twin_pairs *pairs)
{
    int count = rows->counts[row];
    int32_t v = rows->first_vertex + row;
    if (count > SIDE_ROW_PLACES)
        return true;
    struct eight_sides low = load_storey(rows->storeys + row);
    struct met8 met = meet_within(low.neighbours, low.sides);
    if (!is_plain(low, met, count, v))
        return false;
    if (count <= STOREY_PLACES) {
        put_pairs(low, met, count, pairs);
        return true;
    }
    struct eight_sides high = load_storey(rows->storeys + rows->row_count + row);
    struct met8 met_high = meet_lower(meet_within(high.neighbours, high.sides), high.neighbours,
                                      low.neighbours, low.sides);
    if (!is_plain(high, met_high, count - STOREY_PLACES, v))
        return false;
    put_pairs(low, met, count, pairs);
    put_pairs(high, met_high, count - STOREY_PLACES, pairs);
    return true;
}

TARGET_AVX2 void twins_match_avx2(const struct side_rows *rows, int32_t begin, int32_t end,
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

int64_t twins_avx2(const struct mesh *mesh, void *scratch, void *output)
{
    return twins_by(side_rows_of, twins_match_avx2, mesh, scratch, output);
}

#endif
