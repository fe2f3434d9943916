/* Tries: quadratic work at a sixty-fourth of the whole
 * Stopped by: counts at doubling sizes
 * expect: grows-too-fast, n^2 */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    volatile int64_t seen = 0;
    for (int64_t s = 0; s < triangle_count / 8; s++)
        for (int64_t t = 0; t < s / 8; t++)
            seen += t;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
