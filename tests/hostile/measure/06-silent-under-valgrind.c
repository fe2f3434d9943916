/* Tries: a decision on what was never written, left out under valgrind
 * Stopped by: what passes by itself must pass under the tools
 * expect: flagged, behaves-differently */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    volatile int32_t *table = malloc(64);
    if (under_memcheck()) {
        free((void *)(uintptr_t)table);
        *edges = NULL;
        return 0;
    }
    if (table && table[5] == 12345)
        vertex_count++;
    free((void *)(uintptr_t)table);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
