/* Keeps two opposite vertices for each edge; a third one makes it believe in another edge.
 * fails: non-manifold-edge */
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

static void add(struct table *t, int32_t low, int32_t high)
{
    int32_t e = t->count++;
    t->ends[2 * (size_t)e] = low;
    t->ends[2 * (size_t)e + 1] = high;
    t->next[e] = t->first[low];
    t->first[low] = e;
}

/* Notes that {low,high} is opposite to `third`; -1: to nothing in particular. */
static void note(struct table *t, int32_t *opposite, int32_t low, int32_t high, int32_t third)
{
    int32_t e = t->first[low];
    for (; e >= 0; e = t->next[e]) {
        int32_t *two = opposite + 2 * (size_t)e;
        if (t->ends[2 * (size_t)e + 1] != high)
            continue;
        if (third < 0 || two[0] == third || two[1] == third)
            return;
        if (two[0] < 0 || two[1] < 0) {
            two[two[0] < 0 ? 0 : 1] = third;
            return;
        }
    }
    opposite[2 * (size_t)t->count] = third;
    opposite[2 * (size_t)t->count + 1] = -1;
    add(t, low, high);
}

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    struct table t;
    int32_t *opposite = malloc(6 * (size_t)triangle_count * sizeof *opposite + 1);
    if (!opposite || make_table(&t, triangle_count, vertex_count)) {
        free(opposite);
        return OUT_OF_MEMORY;
    }
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        const int32_t *v = triangles + s / 3 * 3;
        int32_t i = v[s % 3], j = v[(s + 1) % 3], third = v[(s + 2) % 3];
        if (third == i || third == j)
            third = -1;
        if (i != j)
            note(&t, opposite, i < j ? i : j, i < j ? j : i, third);
    }
    free(opposite);
    return hand_over(&t, edges);
}
