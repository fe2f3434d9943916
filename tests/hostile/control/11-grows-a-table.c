/* Tries: realloc, calloc, and freeing NULL
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    int32_t *table = NULL;
    for (size_t n = 1; n < 64; n *= 2) {
        int32_t *grown = realloc(table, n * sizeof *table);
        if (!grown) {
            free(table);
            return OUT_OF_MEMORY;
        }
        table = grown;
    }
    free(table);
    free(NULL);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
