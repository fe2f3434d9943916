/* Tries: to leave blocks of no bytes, which cost memory that no count of bytes sees
 * Stopped by: blocks are counted, too
 * expect: leak, leak */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

static void *volatile lost;

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    lost = malloc(0);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
