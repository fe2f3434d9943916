/* Tries: to answer for the allocation shim
 * Stopped by: the screen of the object
 * expect: compile-error, forbidden-symbol */
#include "edge-table-closed.h"
#include "honest.h"

void *__wrap_malloc(size_t size);

void *__wrap_malloc(size_t size)
{
    static char arena[1 << 20];
    return size < sizeof arena ? arena : NULL;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
