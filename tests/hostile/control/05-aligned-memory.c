/* Tries: aligned blocks of every kind
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    void *block = NULL;
    if (posix_memalign(&block, 64, 1000) != 0 || (uintptr_t)block % 64)
        return OUT_OF_MEMORY;
    free(block);
    block = aligned_alloc(4096, 8192);
    if (!block)
        return OUT_OF_MEMORY;
    free(block);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
