/* Tries: edges between vertices that there are not
 * Stopped by: the judge: every index is checked before use
 * expect: wrong-answer, index-out-of-range */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    int64_t count = honest_edges(triangles, triangle_count, edges);
    for (int64_t i = 0; i < 2 * count; i++)
        (*edges)[i] = i % 2 ? INT32_MAX : INT32_MIN;
    return count;
}
