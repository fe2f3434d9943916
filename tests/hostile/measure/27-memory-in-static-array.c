/* Tries: memory that malloc does not see: a static array
 * Stopped by: static data count as memory
 * expect: too-much-memory, memory-band */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

static volatile char arena[12 << 20];

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    for (size_t i = 0; i < sizeof arena; i += 4096)
        arena[i] = (char)triangle_count;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
