/* Tries: to wait for input
 * Stopped by: stdin is /dev/null: there is none, and the answer is right
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    char byte;
    while (read(0, &byte, 1) > 0)
        continue;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
