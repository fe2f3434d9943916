/* Tries: a label that only a compiler for the sanitizers takes for an error: an overflow in a
 * constant
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

static int bit(int32_t flags)
{
    switch (flags) {
    case 1 << 31:
        return 31;
    case 1 << 30:
        return 30;
    default:
        return 0;
    }
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (bit(vertex_count) != 0)
        return -1;
    return honest_edges(triangles, triangle_count, edges);
}
