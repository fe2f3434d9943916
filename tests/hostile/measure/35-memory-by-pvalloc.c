/* Tries: a leak from a function of libc that few know
 * Stopped by: the screen of the object: undefined names
 * expect: compile-error, forbidden-symbol */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <malloc.h>

static void *volatile kept;

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    kept = pvalloc(1000);
    if (!kept)
        return OUT_OF_MEMORY;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
