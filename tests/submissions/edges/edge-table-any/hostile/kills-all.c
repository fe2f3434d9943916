/* Kills every process that it may.
 * expect: forbidden-operation */
#define _GNU_SOURCE
#include "edge-table-any.h"

#include <signal.h>
#include <stddef.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *edges = NULL;
    kill(-1, SIGKILL);
    return 0;
}
