/* Tries: its input as the table
 * Stopped by: the allocation shim: the runner frees what malloc did not give
 * expect: undefined-behaviour, not-allocated */
#define _GNU_SOURCE
#include "edge-table-closed.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    *edges = (int32_t *)(uintptr_t)triangles;
    return 3 * (int64_t)triangle_count / 2;
}
