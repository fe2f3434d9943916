/* Makes one number i * V + j of an edge, in 32 bits: from 65536 vertices on, edges share numbers.
 * fails: high-numbers */
#include "edge-table-closed.h"

#include <stdlib.h>

static int compare(const void *a, const void *b)
{
    const uint32_t *p = a, *q = b;
    return (*p > *q) - (*p < *q);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    uint32_t *keys = malloc(3 * (size_t)triangle_count * sizeof *keys + 1);
    int32_t *table = calloc(6 * (size_t)triangle_count + 2, sizeof *table);
    if (!keys || !table) {
        free(keys);
        free(table);
        return OUT_OF_MEMORY;
    }
    uint32_t n = (uint32_t)vertex_count;
    size_t side_count = 0;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        if (i != j)
            keys[side_count++] = (uint32_t)(i < j ? i : j) * n + (uint32_t)(i < j ? j : i);
    }
    qsort(keys, side_count, sizeof *keys, compare);
    int64_t count = 0;
    for (size_t s = 0; s < side_count; s++)
        if (s == 0 || keys[s] != keys[s - 1]) {
            table[2 * count] = (int32_t)(keys[s] / n);
            table[2 * count++ + 1] = (int32_t)(keys[s] % n);
        }
    free(keys);
    *edges = table;
    return count;
}
