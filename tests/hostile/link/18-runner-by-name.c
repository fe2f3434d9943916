/* Tries: to call the runner's own function
 * Stopped by: the link: the runner's names are local
 * expect: compile-error, link */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

void run_call(void *input, void *answer);

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    run_call(NULL, NULL);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
