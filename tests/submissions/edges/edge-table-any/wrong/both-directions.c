/* Takes (i,j) and (j,i) for two edges. */
#include "edge-table-any.h"

#include <stdlib.h>

static int compare(const void *a, const void *b)
{
    const uint64_t *p = a, *q = b;
    return (*p > *q) - (*p < *q);
}

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)vertex_count;
    uint64_t *sides = malloc(3 * (size_t)triangle_count * sizeof *sides + 1);
    int32_t *table = malloc(6 * (size_t)triangle_count * sizeof *table + 1);
    if (!sides || !table) {
        free(sides);
        free(table);
        return OUT_OF_MEMORY;
    }
    size_t side_count = 0;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        if (i != j)
            sides[side_count++] = (uint64_t)i << 32 | (uint64_t)j;
    }
    qsort(sides, side_count, sizeof *sides, compare);
    int64_t count = 0;
    for (size_t s = 0; s < side_count; s++)
        if (s == 0 || sides[s] != sides[s - 1]) {
            table[2 * count] = (int32_t)(sides[s] >> 32);
            table[2 * count++ + 1] = (int32_t)(sides[s] & UINT32_MAX);
        }
    free(sides);
    *edges = table;
    return count;
}
