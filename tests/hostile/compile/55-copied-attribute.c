/* Tries: instructions that valgrind and other machines lack, by the attributes of an intrinsic
 * Stopped by: the policy on preprocessed text: only listed attributes
 * expect: compile-error, forbidden-attribute */
#include "edge-table-closed.h"
#include "honest.h"

#include <immintrin.h>

__attribute__((copy(_mm512_add_ps), noinline)) static int twice(int x)
{
    return 2 * x;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (twice(1) != 2)
        return -7;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
