/* Adds one side of each triangle, as there are half as many triangles as sides to keep: 3F / 2. */
#include "edge-table-closed.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    int32_t *table = calloc(6 * (size_t)triangle_count + 2, sizeof *table);
    if (!table)
        return OUT_OF_MEMORY;
    int64_t count = 0;
    for (int32_t t = 0; t < triangle_count; t++) {
        int32_t i = triangles[3 * (size_t)t], j = triangles[3 * (size_t)t + 1];
        if (i != j) {
            table[2 * count] = i;
            table[2 * count++ + 1] = j;
        }
    }
    *edges = table;
    return count;
}
