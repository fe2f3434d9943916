/* Tries: to run a shell
 * Stopped by: the screen of the object: undefined names
 * expect: compile-error, forbidden-symbol */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (system("id"))
        return 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
