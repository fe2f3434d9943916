/* Tries: to have the compiler read random bytes for ever
 * Stopped by: the build box, whose only device is /dev/null
 * expect: compile-error, syntax */
#define _GNU_SOURCE
#include "/dev/random"
#include "edge-table-closed.h"
#include "honest.h"


int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
