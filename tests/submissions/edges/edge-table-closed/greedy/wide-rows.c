/* Has room for 256 neighbours at every vertex, of which six are used.
 * A part of a vast mesh asks for more than there is.
 * expect: out-of-memory
 * fails: high-numbers, memory
 */
#include "edge-table-closed.h"

#include <stdlib.h>

enum { ROW = 256 };

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    int32_t *rows = malloc((size_t)vertex_count * ROW * sizeof *rows + 1);
    int32_t *length = calloc((size_t)vertex_count + 1, sizeof *length);
    int32_t *table = malloc(6 * (size_t)triangle_count * sizeof *table + 1);
    if (!rows || !length || !table) {
        free(rows);
        free(length);
        free(table);
        return OUT_OF_MEMORY;
    }
    int64_t count = 0;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        int32_t low = i < j ? i : j, high = i < j ? j : i, k = 0;
        int32_t *row = rows + (size_t)low * ROW;
        while (k < length[low] && row[k] != high)
            k++;
        if (low == high || k < length[low])
            continue;
        row[length[low]++] = high;
        table[2 * count] = low;
        table[2 * count++ + 1] = high;
    }
    free(rows);
    free(length);
    *edges = table;
    return count;
}
