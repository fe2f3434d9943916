/* Tries: to slow the reference, which runs next, by dirty memory: 64 MB in every call
 * Stopped by: what it writes is its own counted work
 * expect: too-much-work, work-band */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static char *block;
    if (!block)
        block = malloc(64 << 20);
    for (size_t i = 0; block && i < 64 << 20; i += 64)
        ((volatile char *)block)[i]++;
    free(block);
    block = NULL;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
