/* Tries: a read past its table, left out when the environment shows a tool
 * Stopped by: the runner: the tools' settings are out of sight
 * expect: undefined-behaviour, found */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    volatile size_t bytes = 64; /* out of sight of UBSan */
    volatile int32_t *table = malloc(bytes);
    if (!getenv("ASAN_OPTIONS") && !getenv("LD_PRELOAD") && !getenv("GLIBC_TUNABLES"))
        vertex_count += table ? table[16] : 0;
    free((void *)(uintptr_t)table);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
