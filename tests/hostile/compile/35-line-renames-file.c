/* Tries: to make the policy believe that this is a system header
 * Stopped by: the policy: #line may not rename the file
 * expect: compile-error, forbidden-line */
#include "edge-table-closed.h"
#include "honest.h"

#line 1 "/usr/include/x86_64-linux-gnu/bits/types.h"
int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
