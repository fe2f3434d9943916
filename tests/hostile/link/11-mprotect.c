/* Tries: code of its own
 * Stopped by: the screen of the object: undefined names
 * expect: compile-error, forbidden-symbol */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <sys/mman.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    mprotect(edges, 4096, PROT_READ | PROT_WRITE | PROT_EXEC);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
