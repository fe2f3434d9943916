/* Tries: a resolver, which runs before constructors
 * Stopped by: the policy on preprocessed text
 * expect: compile-error, forbidden-attribute */
#include "edge-table-closed.h"
#include "honest.h"

#include <unistd.h>

static void *resolve(void)
{
    _exit(0);
}

void early(void) __attribute__((ifunc("resolve")));

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
