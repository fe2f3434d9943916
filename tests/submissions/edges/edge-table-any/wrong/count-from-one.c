/* Counts the changes in the sorted sides and starts at one, also when there is no side at all.
 * fails: empty */
#include "edge-table-any.h"

#include <stdlib.h>

struct side {
    int32_t low, high;
};

static int compare(const void *a, const void *b)
{
    const struct side *p = a, *q = b;
    if (p->low != q->low)
        return p->low < q->low ? -1 : 1;
    return (p->high > q->high) - (p->high < q->high);
}

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)vertex_count;
    struct side *sides = calloc(3 * (size_t)triangle_count + 1, sizeof *sides);
    int32_t *table = malloc((6 * (size_t)triangle_count + 2) * sizeof *table);
    if (!sides || !table) {
        free(sides);
        free(table);
        return OUT_OF_MEMORY;
    }
    size_t side_count = 0;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        if (i != j)
            sides[side_count++] = (struct side){i < j ? i : j, i < j ? j : i};
    }
    qsort(sides, side_count, sizeof *sides, compare);
    int64_t count = 1;
    table[0] = sides[0].low;
    table[1] = sides[0].high;
    for (size_t s = 1; s < side_count; s++)
        if (compare(&sides[s], &sides[s - 1]) != 0) {
            table[2 * count] = sides[s].low;
            table[2 * count++ + 1] = sides[s].high;
        }
    free(sides);
    *edges = table;
    return count;
}
