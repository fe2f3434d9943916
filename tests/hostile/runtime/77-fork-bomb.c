/* Tries: to fill the table of processes
 * Stopped by: the seccomp filter of the run box; too-many-processes, not forbidden-operation,
 * since it would make one
 * expect: too-many-processes, clone */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    for (;;)
        fork();
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
