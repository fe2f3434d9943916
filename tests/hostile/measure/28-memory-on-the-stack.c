/* Tries: memory that malloc does not see: the stack
 * Stopped by: the pages of the stack are given back before the call, and looked at after it
 * expect: too-much-memory, memory-band */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    volatile char arena[6 << 20];
    for (size_t i = 0; i < sizeof arena; i += 4096)
        arena[i] = (char)triangle_count;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
