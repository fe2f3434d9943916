/* Tries: a read past its table, left out under the sanitizer: ends the program
 * Stopped by: what passes by itself must come back under the tools
 * expect: flagged, behaves-differently */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>
#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    volatile int32_t *table = malloc(64);
    if (under_sanitizer())
        _exit(0);
    vertex_count += table ? table[16] : 0;
    free((void *)(uintptr_t)table);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
