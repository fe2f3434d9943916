/* Tries: a block of every call, kept reachable so that no leak checker complains
 * Stopped by: the allocation shim counts what a call leaves
 * expect: leak, leak */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

static void *volatile kept;

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    kept = malloc(1000);
    if (!kept)
        return OUT_OF_MEMORY;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
