/* Tries: a search tree of libc, for the first thousand edges, which is given back
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <search.h>
#include <stdlib.h>

static int by_ends(const void *a, const void *b)
{
    const int32_t *x = a, *y = b;
    return x[0] != y[0] ? (x[0] > y[0]) - (x[0] < y[0]) : (x[1] > y[1]) - (x[1] < y[1]);
}

static void keep(void *edge)
{
    (void)edge;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    enum { MOST = 1000 };
    void *root = NULL;
    int64_t count = honest_edges(triangles, triangle_count, edges);
    (void)vertex_count;
    for (int64_t i = 0; i < count && i < MOST; i++)
        if (!tsearch(*edges + 2 * i, &root, by_ends)) {
            tdestroy(root, keep);
            free(*edges);
            return -1;
        }
    tdestroy(root, keep);
    return count;
}
