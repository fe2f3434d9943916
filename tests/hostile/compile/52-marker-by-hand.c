/* Tries: compiler options of its own in what a line marker, made by hand, says to be a system header
 * Stopped by: the policy on the source: no hand-made markers
 * expect: compile-error, forbidden-line */
#include "edge-table-closed.h"
#include "honest.h"

# 1 "/usr/include/stdio.h" 1 3
#pragma GCC target("avx2")
# 11 "edge-table-closed.c" 2

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
