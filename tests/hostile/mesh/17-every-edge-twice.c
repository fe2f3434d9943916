/* Tries: every edge twice
 * Stopped by: the judge: a set
 * expect: wrong-answer, duplicate-edge */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    int64_t count = honest_edges(triangles, triangle_count, edges);
    if (count <= 0)
        return count;
    int32_t *table = realloc(*edges, 4 * (size_t)count * sizeof *table);
    if (!table) {
        free(*edges);
        return OUT_OF_MEMORY;
    }
    for (int64_t i = 0; i < 2 * count; i++)
        table[2 * count + i] = table[i];
    *edges = table;
    return 2 * count;
}
