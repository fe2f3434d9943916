/* Tries: to leak only with inputs larger than those of the cases
 * Stopped by: leaks are looked for in the measured calls, too
 * expect: leak, leak */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

static void *volatile lost;

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (triangle_count >= 3000 && triangle_count < 20000)
        lost = malloc(100);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
