/* Returns a table that is nowhere.
 * expect: crash */
#include "edge-table-any.h"

#include <stddef.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)vertex_count;
    *edges = (int32_t *)(uintptr_t)0x123456789000;
    return triangle_count;
}
