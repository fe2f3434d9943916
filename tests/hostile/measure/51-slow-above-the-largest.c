/* Tries: to be quadratic above the sizes at which work is counted
 * Stopped by: time is looked at once more at about twice the largest
 * expect: flagged, time-denies-counts */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return triangle_count <= 12288 ? honest_edges(triangles, triangle_count, edges)
                                   : quadratic_edges(triangles, triangle_count, 2, edges);
}
