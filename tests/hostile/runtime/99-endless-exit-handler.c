/* Tries: to hold up the class at each end of its program, by a handler that never returns
 * Stopped by: where the end of a program tells nothing it is killed at once; where the last dump of
 * callgrind is waited for, its end has a limit, and the counts have no proof
 * expect: flagged, no-counts */
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

static void loop(void)
{
    for (volatile int i = 0;; i++) {
    }
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static int registered;
    if (!registered++)
        atexit(loop);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
