/* Returns a count, and NULL for the table.
 * expect: wrong-answer */
#include "edge-table-any.h"

#include <stddef.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)vertex_count;
    *edges = NULL;
    return triangle_count;
}
