/* Tries: a square of bits at all sizes but the largest at which work is counted
 * Stopped by: memory is judged at every size
 * expect: too-much-memory, memory-band */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    size_t bytes = triangle_count < 6000 ? (size_t)triangle_count * (size_t)triangle_count : 1;
    char *pairs = malloc(bytes + 1);
    if (!pairs)
        return -1;
    pairs[bytes] = 1;
    int64_t count = honest_edges(triangles, triangle_count, edges);
    free(pairs);
    (void)vertex_count;
    return count;
}
