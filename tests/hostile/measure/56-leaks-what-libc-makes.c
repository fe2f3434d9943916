/* Tries: to leave a block that libc asked for
 * Stopped by: what libc asks for on the student's behalf is the student's
 * expect: leak, leak */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdio.h>

static char *lost;

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    if (asprintf(&lost, "%d triangles", triangle_count) < 0)
        return -1;
    return honest_edges(triangles, triangle_count, edges);
}
