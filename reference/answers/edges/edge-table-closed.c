/* Problem 4.5 (b): every edge is met twice, once as (i,j) and once as (j,i). Exactly one of the
 * two runs from the smaller number to the larger, so keeping only those lists every edge once:
 * one pass, no search, no memory but the table. F triangles have 3F/2 edges. */
#include "edge-table-closed.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    *edges = NULL;
    if (triangle_count == 0)
        return 0;
    size_t side_count = 3 * (size_t)triangle_count;
    /* One entry more: every side is written, and only those to keep are stepped over. */
    int32_t *table = malloc((side_count / 2 + 1) * 2 * sizeof *table);
    if (!table)
        return OUT_OF_MEMORY;
    int32_t *end = table;
    for (size_t side = 0; side < side_count; side += 3) {
        int32_t a = triangles[side], b = triangles[side + 1], c = triangles[side + 2];
        int32_t start[3] = {a, b, c}, stop[3] = {b, c, a};
        for (int k = 0; k < 3; k++) {
            end[0] = start[k];
            end[1] = stop[k];
            end += start[k] < stop[k] ? 2 : 0;
        }
    }
    *edges = table;
    return (end - table) / 2;
}
