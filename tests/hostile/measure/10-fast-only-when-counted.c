/* Tries: quadratic work that is left out when its stack shows that it is counted
 * Stopped by: the engine: the time of paired runs on meshes that nobody knows
 * expect: flagged, time-denies-counts */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

/* Right, in quadratic time: looks for each side whether it came before. */
static int64_t quadratic(const int32_t *triangles, int32_t triangle_count, int32_t **edges)
{
    volatile int64_t seen = 0;
    for (int64_t s = 0; s < 3 * (int64_t)triangle_count; s++)
        for (int64_t t = 0; t < s; t++)
            seen += triangles[t] == triangles[s];
    return honest_edges(triangles, triangle_count, edges);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (under_callgrind())
        return honest_edges(triangles, triangle_count, edges);
    (void)vertex_count;
    return quadratic(triangles, triangle_count, edges);
}
