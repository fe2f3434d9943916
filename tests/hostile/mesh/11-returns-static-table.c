/* Tries: a static table
 * Stopped by: the allocation shim
 * expect: undefined-behaviour, not-allocated */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static int32_t table[1 << 18];
    int32_t *made = NULL;
    (void)vertex_count;
    int64_t count = honest_edges(triangles, triangle_count, &made);
    for (int64_t i = 0; i < 2 * count && i < 1 << 18; i++)
        table[i] = made[i];
    free(made);
    *edges = table;
    return count;
}
