/* Tries: the same, behind a comment and with the name in a macro
 * Stopped by: the policy on the source: no hand-made markers
 * expect: compile-error, forbidden-line */
#include "edge-table-closed.h"
#include "honest.h"

#define HEADER "/usr/include/stdio.h"
/* */ # /* a
 */ 1 HEADER 1 3
#pragma GCC push_options
#pragma GCC target("avx2")
#line 13

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
