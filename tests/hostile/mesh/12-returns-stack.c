/* Tries: an array of its own frame
 * Stopped by: the allocation shim
 * expect: undefined-behaviour, not-allocated */
#define _GNU_SOURCE
#include "edge-table-closed.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    int32_t frame[64] = {0};
    int32_t *volatile hidden = frame;
    (void)triangles;
    (void)vertex_count;
    *edges = hidden;
    return triangle_count > 0;
}
