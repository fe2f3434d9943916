/* Tries: to end by abort
 * Stopped by: its true name
 * expect: crash, abort */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    abort();
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
