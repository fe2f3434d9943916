/* Tries: to test every other block that it asks for only, after the first ten
 * Stopped by: of many allocations the first are refused, and of the rest a drawn sample of both
 * parities
 * expect: crash, allocation-failure */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

enum { BLOCKS = 38, TESTED = 10 }; /* an even number of requests in all */

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    char *volatile blocks[BLOCKS] = {NULL};
    int64_t count = OUT_OF_MEMORY;
    int made = 0;
    (void)vertex_count;
    for (; made < BLOCKS; made++) {
        blocks[made] = malloc(16);
        if (made < TESTED || made % 2 == 0) {
            if (!blocks[made])
                break;
        }
        *blocks[made] = 1;
    }
    if (made == BLOCKS)
        count = honest_edges(triangles, triangle_count, edges);
    for (int i = 0; i < BLOCKS; i++)
        free(blocks[i]);
    return count;
}
