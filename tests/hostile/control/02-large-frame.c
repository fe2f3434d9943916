/* Tries: 1 MB of local variables
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    volatile char frame[1 << 20];
    frame[(size_t)triangle_count % sizeof frame] = 1;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
