/* Tries: one number past the end of its table
 * Stopped by: the sanitizers
 * expect: undefined-behaviour, found */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    int64_t count = honest_edges(triangles, triangle_count, edges);
    if (count > 0)
        (*edges)[2 * count] = 7;
    return count;
}
