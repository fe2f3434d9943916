/* Returns a table that it never fills.
 * expect: undefined-behaviour */
#include "edge-table-any.h"

#include <stdlib.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)vertex_count;
    int64_t count = 3 * (int64_t)triangle_count / 2;
    *edges = malloc(2 * (size_t)count * sizeof **edges + 1);
    return *edges ? count : OUT_OF_MEMORY;
}
