/* Tries: a crash
 * Stopped by: its true name
 * expect: crash, division */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    volatile int32_t zero = 0;
    if (vertex_count / zero == 7)
        return 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
