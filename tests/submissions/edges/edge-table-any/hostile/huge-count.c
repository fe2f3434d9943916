/* Returns more edges than there are numbers for.
 * expect: wrong-answer */
#include "edge-table-any.h"

#include <stdlib.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *edges = calloc(2, sizeof **edges);
    return *edges ? INT64_MAX : OUT_OF_MEMORY;
}
