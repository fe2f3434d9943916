/* Tries: to change its input and change it back
 * Stopped by: the input is mapped read-only, of a sealed file
 * expect: crash, input */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    int32_t *writable = (int32_t *)(uintptr_t)triangles;
    if (triangle_count > 0) {
        int32_t kept = writable[0];
        writable[0] = *(volatile int32_t *)&kept + 1;
        *(volatile int32_t *)writable = kept;
    }
    return honest_edges(triangles, triangle_count, edges);
}
