/* Tries: a local array of 1 GB
 * Stopped by: the stack's limit; the runner's handler names it
 * expect: crash, stack-overflow */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <alloca.h>
#include <stddef.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    volatile char *block = alloca(1u << 30);
    for (size_t i = (size_t)1 << 30; i > 0; i -= 4096)
        block[i - 1] = 1;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
