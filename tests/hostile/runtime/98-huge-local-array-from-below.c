/* Tries: a local array of 1 GB, written from its far end on
 * Stopped by: the stack's limit; the runner's handler sees where the frame is
 * expect: crash, stack-overflow */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stddef.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    volatile char block[1 << 30];
    for (size_t i = 0; i < sizeof block; i += 4096)
        block[i] = 1;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
