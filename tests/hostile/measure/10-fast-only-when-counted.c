/* Tries: quadratic work that is left out when its stack shows that it is counted
 * Stopped by: the engine: the time of paired runs on meshes that nobody knows
 * expect: flagged, time-denies-counts */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"


int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (under_callgrind())
        return honest_edges(triangles, triangle_count, edges);
    (void)vertex_count;
    return quadratic_edges(triangles, triangle_count, 1, edges);
}
