/* Forgets to free marks that it does not even need. */
#include "edge-table-closed.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    char *met = calloc((size_t)vertex_count + 1, 1);
    if (!met)
        return OUT_OF_MEMORY;
    int32_t *table = calloc(6 * (size_t)triangle_count + 2, sizeof *table);
    if (!table) {
        free(met);
        return OUT_OF_MEMORY;
    }
    int64_t count = 0;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        met[i] = 1;
        if (i < j) {
            table[2 * count] = i;
            table[2 * count++ + 1] = j;
        }
    }
    *edges = table;
    return count;
}
