/* Tries: memory in the kernel
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, socketpair */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <sys/socket.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    int ends[2];
    socketpair(AF_UNIX, SOCK_STREAM, 0, ends);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
