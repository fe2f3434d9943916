/* Tries: much more work than is counted: what is left out under callgrind, is
 * within thirty times the counted cost, which is kept near to the band
 * Stopped by: the engine: the time that an honest program of that cost could take
 * expect: flagged, time-denies-counts */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static volatile int32_t kept;
    int32_t sum = vertex_count;
    for (int pass = under_callgrind() ? 24 : 600; pass > 0; pass--)
        for (int64_t s = 0; s < 3 * (int64_t)triangle_count; s++)
            sum = (int32_t)((uint32_t)sum * 31 + (uint32_t)triangles[s]);
    kept = sum;
    return honest_edges(triangles, triangle_count, edges);
}
