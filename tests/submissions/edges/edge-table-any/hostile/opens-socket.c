/* Talks to the network.
 * expect: forbidden-operation */
#define _GNU_SOURCE
#include "edge-table-any.h"

#include <stddef.h>
#include <sys/socket.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *edges = NULL;
    return socket(AF_INET, SOCK_STREAM, 0) >= 0 ? 1 : 0;
}
