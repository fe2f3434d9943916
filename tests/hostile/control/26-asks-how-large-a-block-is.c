/* Tries: to ask how large a block is, and to use all of it
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <malloc.h>
#include <string.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    char *block = malloc(1000);
    (void)vertex_count;
    if (!block)
        return -1;
    memset(block, 0, malloc_usable_size(block));
    free(block);
    return honest_edges(triangles, triangle_count, edges);
}
