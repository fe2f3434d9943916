/* Reads one triangle's side behind the end of its input, where zeros happen to lie.
 * expect: undefined-behaviour */
#include "edge-table-closed.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    int32_t *table = malloc(3 * (size_t)triangle_count * sizeof *table + 1);
    if (!table)
        return OUT_OF_MEMORY;
    int64_t count = 0;
    for (size_t s = 0; s <= 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        if (i > j) {
            table[2 * count] = i;
            table[2 * count + 1] = j;
            count++;
        }
    }
    *edges = table;
    return count;
}
