/* Tries: 10^7 blocks one after the other, on the smallest mesh
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    for (int i = 0; triangle_count == 4 && i < 10000000; i++) {
        void *volatile block = malloc((size_t)i % 64 + 1);
        if (!block)
            return OUT_OF_MEMORY;
        free(block);
    }
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
