/* Tries: far past the end of the triangles
 * Stopped by: the page after the input cannot be read
 * expect: crash, input */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    volatile int32_t sum = 0;
    for (int64_t s = 0; s < (1 << 20); s++)
        sum += triangles[s];
    return honest_edges(triangles, triangle_count, edges);
}
