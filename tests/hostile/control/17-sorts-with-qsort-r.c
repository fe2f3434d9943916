/* Tries: to sort by qsort_r, which asks for a block of its own and gives it back
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdio.h>
#include <stdlib.h>

static int by_ends(const void *a, const void *b, void *vertex_count)
{
    const int32_t *x = a, *y = b;
    const int64_t n = *(const int32_t *)vertex_count;
    const int64_t first = x[0] * n + x[1], second = y[0] * n + y[1];
    return (first > second) - (first < second);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    int64_t count = honest_edges(triangles, triangle_count, edges);
    if (count > 0)
        qsort_r(*edges, (size_t)count, 2 * sizeof **edges, by_ends, &vertex_count);
    return count;
}
