/* The reference's work, REPEATS times. */
#include "edge-table-any.h"

#include <stdlib.h>

int64_t reference_once(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges);

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    for (int i = 1; i < REPEATS; i++) {
        reference_once(triangles, triangle_count, vertex_count, edges);
        free(*edges);
    }
    return reference_once(triangles, triangle_count, vertex_count, edges);
}
