/* For each vertex a linked list, through an array of links, of the edges of which it is the smaller
 * end; the table itself holds the edges. Shrinks the table at the end. */
#include "edge-table-closed.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    int32_t *first = malloc((size_t)vertex_count * sizeof *first + 1);
    int32_t *next = malloc(3 * (size_t)triangle_count * sizeof *next + 1);
    int32_t *table = malloc(6 * (size_t)triangle_count * sizeof *table + 1);
    int32_t count = 0;
    if (!first || !next || !table) {
        free(first);
        free(next);
        free(table);
        return OUT_OF_MEMORY;
    }
    for (int32_t v = 0; v < vertex_count; v++)
        first[v] = -1;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        int32_t low = i < j ? i : j, high = i < j ? j : i;
        int32_t e = first[low];
        while (e >= 0 && table[2 * (size_t)e + 1] != high)
            e = next[e];
        if (e >= 0 || low == high)
            continue;
        table[2 * (size_t)count] = low;
        table[2 * (size_t)count + 1] = high;
        next[count] = first[low];
        first[low] = count++;
    }
    free(first);
    free(next);
    int32_t *shrunk = realloc(table, 2 * (size_t)count * sizeof *table + 1);
    *edges = shrunk ? shrunk : table;
    return count;
}
