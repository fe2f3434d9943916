/* Counts the sides that go from the smaller to the larger number, and then stores them. */
#include "edge-table-closed.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    size_t count = 0;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        count += i < j;
    }
    int32_t *table = malloc(2 * count * sizeof *table + 1);
    if (!table)
        return OUT_OF_MEMORY;
    int32_t *end = table;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        if (i < j) {
            *end++ = i;
            *end++ = j;
        }
    }
    *edges = table;
    return (int64_t)count;
}
