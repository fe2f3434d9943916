/* Tries: recursion to a moderate depth
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

__attribute__((noinline)) static int depth(int n)
{
    return n == 0 ? 0 : 1 + depth(n - 1);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (depth(1000) != 1000)
        return 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
