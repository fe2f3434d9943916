/* Tries: instructions that valgrind and other machines lack
 * Stopped by: the policy on preprocessed text
 * expect: compile-error, forbidden-pragma */
#include "edge-table-closed.h"
#include "honest.h"

#pragma GCC target("avx512f")

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
