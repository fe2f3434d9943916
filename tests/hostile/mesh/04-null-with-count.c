/* Tries: no table, but a count
 * Stopped by: the judge: a claim without elements
 * expect: wrong-answer, no-table */
#define _GNU_SOURCE
#include "edge-table-closed.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)triangles;
    (void)vertex_count;
    *edges = NULL;
    return 3 * (int64_t)triangle_count / 2;
}
