/* Looks for each side through all edges found so far.
 * expect: grows-too-fast */
#include "edge-table-any.h"

#include <stdlib.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)vertex_count;
    int32_t *table = malloc(6 * (size_t)triangle_count * sizeof *table + 1);
    if (!table)
        return OUT_OF_MEMORY;
    int64_t count = 0;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        int32_t low = i < j ? i : j, high = i < j ? j : i;
        int64_t e = 0;
        while (e < count && (table[2 * e] != low || table[2 * e + 1] != high))
            e++;
        if (low == high || e < count)
            continue;
        table[2 * count] = low;
        table[2 * count++ + 1] = high;
    }
    *edges = table;
    return count;
}
