/* Tries: larger pages than the reference has
 * Stopped by: the screen of the object
 * expect: compile-error, forbidden-symbol */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <sys/mman.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    madvise(edges, 4096, MADV_HUGEPAGE);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
