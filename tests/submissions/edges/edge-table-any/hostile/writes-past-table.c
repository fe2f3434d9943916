/* Writes one entry behind the end of the table.
 * expect: undefined-behaviour */
#include "edge-table-any.h"

#include <stdlib.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)vertex_count;
    size_t count = 0;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++)
        count += triangles[s] < triangles[s % 3 == 2 ? s - 2 : s + 1];
    int32_t *table = malloc(2 * count * sizeof *table + 1);
    if (!table)
        return OUT_OF_MEMORY;
    int32_t *end = table;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        end[0] = i;
        end[1] = j;
        end += i < j ? 2 : 0;
    }
    *edges = table;
    return (int64_t)count;
}
