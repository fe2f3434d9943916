/* Tries: to send packets of its own making
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, socket */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <sys/socket.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    socket(AF_INET, SOCK_RAW, 1);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
