/* Tries: a table of rubbish
 * Stopped by: the judge
 * expect: wrong-answer, index-out-of-range */
#define _GNU_SOURCE
#include "edge-table-closed.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)triangles;
    (void)vertex_count;
    *edges = malloc(3 * (size_t)triangle_count * sizeof **edges + 1);
    if (!*edges)
        return OUT_OF_MEMORY;
    for (size_t i = 0; i < 3 * (size_t)triangle_count; i++)
        (*edges)[i] = -1;
    return 3 * (int64_t)triangle_count / 2;
}
