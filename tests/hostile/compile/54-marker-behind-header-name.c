/* Tries: the same where a comment seems to begin, in the name of a header that is only asked for
 * Stopped by: the policy on the source: no odd names of headers
 * expect: compile-error, forbidden-include */
#include "edge-table-closed.h"
#include "honest.h"

#if __has_include(</*>)
#endif
# 1 "/usr/include/stdio.h" 1 3
#pragma GCC target("avx2")
# 13 "edge-table-closed.c" 2 /* */

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
