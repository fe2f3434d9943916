/* Tries: where the runner's data begin and end
 * Stopped by: the screen of the object: names that are on no list
 * expect: compile-error, unknown-symbol */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

extern char __bss_start[], end[];

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    for (char *at = __bss_start; at < end; at++)
        if (*at == 77)
            *at = 78;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
