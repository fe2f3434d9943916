/* Tries: a stack that is not measured, by libgcc
 * Stopped by: the screen of the object: names that are on no list
 * expect: compile-error, forbidden-symbol */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

void *__splitstack_makecontext(size_t, void *[10], size_t *);

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    void *context[10];
    size_t bytes;
    __splitstack_makecontext(1 << 20, context, &bytes);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
