/* For each vertex a linked list, through an array of links, of the edges of which it is the smaller
 * end; the table itself holds the edges. */
#include "edge-table-any.h"

#include <stdlib.h>

/* Edges so far, in a linked list for each smaller end. */
struct table {
    int32_t *first, *next, *ends;
    int32_t count;
};

static int make_table(struct table *t, int32_t triangle_count, int32_t vertex_count)
{
    t->first = malloc((size_t)vertex_count * sizeof *t->first + 1);
    t->next = malloc(3 * (size_t)triangle_count * sizeof *t->next + 1);
    t->ends = calloc(6 * (size_t)triangle_count + 2, sizeof *t->ends);
    t->count = 0;
    if (!t->first || !t->next || !t->ends) {
        free(t->first);
        free(t->next);
        free(t->ends);
        return OUT_OF_MEMORY;
    }
    for (int32_t v = 0; v < vertex_count; v++)
        t->first[v] = -1;
    return 0;
}

static int64_t hand_over(struct table *t, int32_t **edges)
{
    free(t->first);
    free(t->next);
    *edges = t->ends;
    return t->count;
}

/* The number of edge {i,j}, or -1. */
static int32_t find(const struct table *t, int32_t i, int32_t j)
{
    int32_t e = t->first[i < j ? i : j], high = i < j ? j : i;
    while (e >= 0 && t->ends[2 * (size_t)e + 1] != high)
        e = t->next[e];
    return e;
}

static void add(struct table *t, int32_t i, int32_t j)
{
    int32_t low = i < j ? i : j, e = t->count++;
    t->ends[2 * (size_t)e] = low;
    t->ends[2 * (size_t)e + 1] = i < j ? j : i;
    t->next[e] = t->first[low];
    t->first[low] = e;
}

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    struct table t;
    if (make_table(&t, triangle_count, vertex_count))
        return OUT_OF_MEMORY;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        if (i != j && find(&t, i, j) < 0)
            add(&t, i, j);
    }
    return hand_over(&t, edges);
}
