/* Tries: all memory, touched
 * Stopped by: the allocation shim's limit: malloc gives NULL
 * expect: out-of-memory, memory-limit */
#define _GNU_SOURCE
#include "edge-table-closed.h"

#include <stdlib.h>
#include <string.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    void *block;
    while ((block = malloc(1 << 20)) != NULL)
        memset(block, 1, 1 << 20);
    return OUT_OF_MEMORY;
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    (void)edges;
}
