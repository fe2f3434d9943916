/* Tries: a crash
 * Stopped by: its true name
 * expect: crash, null-pointer */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stddef.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    *(volatile int *)NULL = 1;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
