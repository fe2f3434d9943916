/* Tries: to free a block twice
 * Stopped by: the allocation shim
 * expect: undefined-behaviour, not-allocated */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    void *volatile block = malloc(100);
    free(block);
    free(block);
    return honest_edges(triangles, triangle_count, edges);
}
