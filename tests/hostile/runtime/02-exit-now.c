/* Tries: the same without handlers
 * Stopped by: exits are no answers: the nonce was not echoed
 * expect: crash, exit */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    _exit(0);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
