/* Tries: 100,000 small blocks at a time, on the smallest mesh
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

enum { BLOCKS = 100000 };

/* Every block lives until all are there. */
static int take_blocks(void)
{
    void **blocks = malloc(BLOCKS * sizeof *blocks);
    int taken = 0;
    while (blocks && taken < BLOCKS && (blocks[taken] = malloc((size_t)taken % 64 + 1)))
        taken++;
    for (int i = 0; i < taken; i++)
        free(blocks[i]);
    free(blocks);
    return taken;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (triangle_count == 4 && take_blocks() != BLOCKS)
        return OUT_OF_MEMORY;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
