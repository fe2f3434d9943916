/* Calls itself without end.
 * expect: crash */
#include "edge-table-any.h"

#include <stddef.h>

static int64_t depth_below(int64_t depth)
{
    volatile char room[256];
    room[depth % 256] = (char)depth;
    return depth_below(depth + 1) + room[depth % 256];
}

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *edges = NULL;
    return depth_below(0);
}
