/* Tries: to free memory of the grader
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
    free((void *)(uintptr_t)(triangles + 4));
    return honest_edges(triangles, triangle_count, edges);
}
