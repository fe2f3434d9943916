/* Tries: a count of edges that no table holds
 * Stopped by: the judge: a claim without elements
 * expect: wrong-answer, impossible-count */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    int64_t count = honest_edges(triangles, triangle_count, edges);
    return count > 0 ? INT64_MAX : count;
}
