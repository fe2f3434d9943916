/* Tries: right answers while it seems to be warmed up, then none
 * Stopped by: every measured call is a judged call
 * expect: flagged, behaves-differently */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stddef.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static int calls;
    if (calls++ > 0) {
        *edges = NULL;
        return 0;
    }
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
