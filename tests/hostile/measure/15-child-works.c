/* Tries: to have the work done by a child whose time nobody counts
 * Stopped by: the seccomp filter of the run box
 * expect: too-many-processes, clone */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (fork() == 0)
        _exit(0);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
