/* Tries: text to stdout and stderr
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdio.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    printf("triangles: %d\n", triangle_count);
    fprintf(stderr, "debugging, line %d\n", __LINE__);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
