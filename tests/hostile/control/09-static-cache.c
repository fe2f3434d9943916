/* Tries: a table kept from call to call, for speed
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static int32_t powers[32];
    for (int i = 0; i < 32; i++)
        powers[i] = (int32_t)(1u << i);
    if (powers[3] != 8)
        return 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
