/* Tries: to write the counts of the shim
 * Stopped by: the link: the runner's names are local
 * expect: compile-error, link */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

extern int64_t shim_counts[];

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    shim_counts[3] = 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
