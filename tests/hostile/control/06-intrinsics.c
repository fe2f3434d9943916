/* Tries: the instructions that every machine has
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <emmintrin.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    __m128i two = _mm_set1_epi32(2), three = _mm_set1_epi32(3);
    if (_mm_cvtsi128_si32(_mm_add_epi32(two, three)) != 5)
        return 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
