/* Returns its input as the table.
 * expect: undefined-behaviour */
#include "edge-table-any.h"

#include <stddef.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)vertex_count;
    *edges = (int32_t *)(uintptr_t)triangles;
    return triangle_count;
}
