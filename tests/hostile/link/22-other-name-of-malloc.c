/* Tries: memory past the shim, by another name of malloc
 * Stopped by: the screen of the object: names that are on no list
 * expect: compile-error, forbidden-symbol */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <string.h>

void *__malloc(size_t);
void __free(void *);

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    void *past = __malloc(1 << 20);
    memset(past, 1, 1 << 20);
    __free(past);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
