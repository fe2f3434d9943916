/* Tries: to fill the disk
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, openat */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdio.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    tmpfile();
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
