/* Keeps vertex numbers in 16 bits.
 * fails: high-numbers */
#include "edge-table-closed.h"

#include <stdlib.h>

struct side {
    int16_t low, high;
};

static int compare(const void *a, const void *b)
{
    const struct side *p = a, *q = b;
    return p->low != q->low ? p->low - q->low : p->high - q->high;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    struct side *sides = malloc(3 * (size_t)triangle_count * sizeof *sides + 1);
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
            sides[side_count++] = (struct side){(int16_t)(i < j ? i : j), (int16_t)(i < j ? j : i)};
    }
    qsort(sides, side_count, sizeof *sides, compare);
    int64_t count = 0;
    for (size_t s = 0; s < side_count; s++)
        if (s == 0 || compare(&sides[s], &sides[s - 1]) != 0) {
            table[2 * count] = sides[s].low;
            table[2 * count++ + 1] = sides[s].high;
        }
    free(sides);
    *edges = table;
    return count;
}
