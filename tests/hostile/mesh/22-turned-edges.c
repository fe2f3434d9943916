/* Tries: every edge the other way round, last first: allowed
 * Stopped by: nothing: the answer is a set of unordered pairs
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    int64_t count = honest_edges(triangles, triangle_count, edges);
    for (int64_t i = 0, k = 2 * count - 1; i < k; i++, k--) {
        int32_t kept = (*edges)[i];
        (*edges)[i] = (*edges)[k];
        (*edges)[k] = kept;
    }
    return count;
}
