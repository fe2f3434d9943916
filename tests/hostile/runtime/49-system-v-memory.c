/* Tries: memory that outlives it
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, shmget */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <sys/shm.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    shmget(IPC_PRIVATE, 1 << 20, 0600);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
