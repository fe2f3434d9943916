/* Sorts all sides and keeps one of each run of equal ones, as in problem 4.5 (a): none of that is
 * needed here.
 * expect: too-much-work */
#include "edge-table-closed.h"

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

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    struct side *sides = malloc(3 * (size_t)triangle_count * sizeof *sides + 1);
    if (!sides)
        return OUT_OF_MEMORY;
    size_t side_count = 0;
    for (int32_t t = 0; t < triangle_count; t++) {
        const int32_t *v = triangles + 3 * (size_t)t;
        for (int k = 0; k < 3; k++) {
            int32_t i = v[k], j = v[(k + 1) % 3];
            if (i < j)
                sides[side_count++] = (struct side){i, j};
            else if (j < i)
                sides[side_count++] = (struct side){j, i};
        }
    }
    qsort(sides, side_count, sizeof *sides, compare);
    size_t edge_count = 0;
    for (size_t s = 0; s < side_count; s++)
        if (s == 0 || compare(&sides[s], &sides[s - 1]) != 0)
            sides[edge_count++] = sides[s];
    int32_t *table = malloc(edge_count * 2 * sizeof *table + 1);
    if (!table) {
        free(sides);
        return OUT_OF_MEMORY;
    }
    for (size_t e = 0; e < edge_count; e++) {
        table[2 * e] = sides[e].low;
        table[2 * e + 1] = sides[e].high;
    }
    free(sides);
    *edges = table;
    return (int64_t)edge_count;
}
