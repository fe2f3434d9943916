/* Tries: to learn of the engine by its environment
 * Stopped by: the box's own three variables
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    const char *path = getenv("PATH");
    if (getenv("MESHGRADE_ROOT") || getenv("HOME") || !path)
        return 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
