/* Tries: a block of 2^60 bytes, used without a look
 * Stopped by: the allocation shim's limit: malloc gives NULL
 * expect: out-of-memory, memory-limit */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    volatile char *block = malloc((size_t)1 << 60);
    block[0] = 1;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
