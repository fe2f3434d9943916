/* Tries: a count beyond the end of its table
 * Stopped by: the runner reads as far as the count says, and faults or finds rubbish
 * expect: crash, wild-pointer */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    int64_t count = honest_edges(triangles, triangle_count, edges);
    return count > 0 ? 2 * count : count;
}
