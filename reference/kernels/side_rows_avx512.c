/* Rows of sides: the triangles are turned to their smallest corner sixteen at a time; see
 * side_rows.h. */
#include "reference/kernels/corners_avx512.h"
#include "reference/kernels/order.h"
#include "reference/kernels/side_rows.h"

#if defined(__x86_64__)

/* What sixteen triangles enter: two places into the row of their smallest corner and one into that
 * of the smaller other. */
struct block {
    uint64_t first[16], second[16], third[16];
    uint32_t smallest[16], smaller[16];
} __attribute__((aligned(64)));

TARGET_AVX512 static inline void turn16(struct block *block, const int32_t *t, uint32_t side)
{
    struct corners16 k = load_corners16(t);
    const __m512i one = _mm512_set1_epi32(1), two = _mm512_set1_epi32(2);
    const __m512i none = _mm512_setzero_si512(), back = _mm512_set1_epi32(INT32_MIN);
    __m512i numbers = _mm512_add_epi32(
        _mm512_set1_epi32((int)side),
        _mm512_setr_epi32(0, 3, 6, 9, 12, 15, 18, 21, 24, 27, 30, 33, 36, 39, 42, 45));
    __m512i less = _mm512_min_epi32(k.x, k.y);
    __mmask16 at_y = _mm512_cmplt_epi32_mask(k.y, k.x), at_z = _mm512_cmplt_epi32_mask(k.z, less);
    __m512i b = _mm512_mask_mov_epi32(_mm512_mask_mov_epi32(k.y, at_y, k.z), at_z, k.x);
    __m512i c = _mm512_mask_mov_epi32(_mm512_mask_mov_epi32(k.z, at_y, k.x), at_z, k.y);
    __m512i p = _mm512_mask_mov_epi32(_mm512_mask_mov_epi32(none, at_y, one), at_z, two);
    __m512i q = _mm512_mask_mov_epi32(_mm512_mask_mov_epi32(one, at_y, two), at_z, none);
    __m512i r = _mm512_mask_mov_epi32(_mm512_mask_mov_epi32(two, at_y, none), at_z, one);
    __mmask16 backward = _mm512_cmpge_epi32_mask(b, c);
    __m512i second = _mm512_or_si512(_mm512_add_epi32(numbers, r), back);
    __m512i third = _mm512_add_epi32(numbers, q);
    third = _mm512_mask_or_epi32(third, backward, third, back);
    store_halves16(block->first, b, _mm512_add_epi32(numbers, p));
    store_halves16(block->second, c, second);
    store_halves16(block->third, _mm512_max_epi32(b, c), third);
    _mm512_store_si512(block->smallest, _mm512_min_epi32(less, k.z));
    _mm512_store_si512(block->smaller, _mm512_min_epi32(b, c));
}

TARGET_AVX512 static inline void enter16(struct filling f, const struct block *block)
{
    for (int k = 0; k < 16; k++) {
        filling_add_two(f, (int32_t)block->smallest[k], block->first[k], block->second[k]);
        filling_add_one(f, (int32_t)block->smaller[k], block->third[k]);
    }
}

TARGET_AVX512 static inline void prefetch16(struct filling f, const struct block *block)
{
    for (int k = 0; k < 16; k++) {
        filling_prefetch(f, (int32_t)block->smallest[k]);
        filling_prefetch(f, (int32_t)block->smaller[k]);
    }
}

/* Both return how many triangles they entered; the rest is less than two blocks. */

/* Neighbouring triangles enter the same rows, and a count can be read again only some time after it
 * was written: two blocks side by side hide that. */
TARGET_AVX512 static uint32_t fill(struct filling f, const struct mesh *mesh)
{
    struct block a, b;
    uint32_t t = 0, stop = (uint32_t)mesh->triangle_count;
    for (; t + 32 <= stop; t += 32) {
        turn16(&a, mesh->triangles + 3 * (size_t)t, 3 * t);
        turn16(&b, mesh->triangles + 3 * (size_t)(t + 16), 3 * (t + 16));
        for (int k = 0; k < 16; k++) {
            filling_add_two(f, (int32_t)a.smallest[k], a.first[k], a.second[k]);
            filling_add_two(f, (int32_t)b.smallest[k], b.first[k], b.second[k]);
            filling_add_one(f, (int32_t)a.smaller[k], a.third[k]);
            filling_add_one(f, (int32_t)b.smaller[k], b.third[k]);
        }
    }
    return t;
}

TARGET_AVX512 static uint32_t fill_with_prefetch(struct filling f, const struct mesh *mesh)
{
    struct block blocks[2];
    uint32_t k = 0, stop = (uint32_t)mesh->triangle_count;
    if (stop < 32)
        return 0;
    turn16(&blocks[0], mesh->triangles, 0);
    for (; k + 32 <= stop; k += 16) {
        struct block *now = &blocks[k / 16 % 2], *next = &blocks[1 - k / 16 % 2];
        turn16(next, mesh->triangles + 3 * (size_t)(k + 16), 3 * (k + 16));
        prefetch16(f, next);
        enter16(f, now);
    }
    return k;
}

TARGET_AVX512 struct side_rows side_rows_of_avx512(const struct mesh *mesh, void *scratch)
{
    struct side_rows rows = side_rows_begin(mesh, scratch);
    struct filling f = {rows.counts, rows.storeys, rows.row_count, &rows};
    side_rows_fill_from(f, mesh,
                        order_is_scattered(mesh) ? fill_with_prefetch(f, mesh) : fill(f, mesh));
    return rows;
}

#endif
