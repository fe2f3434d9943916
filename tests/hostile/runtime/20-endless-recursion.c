/* Tries: to use up the stack
 * Stopped by: the stack's limit; the runner's handler names it
 * expect: crash, stack-overflow */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

__attribute__((noinline)) static int64_t deeper(int64_t level)
{
    volatile char frame[1024];
    frame[level % 1024] = 1;
    return level == INT64_MAX ? 0 : deeper(level + 1) + frame[level % 1024];
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (deeper(triangle_count) == 7)
        return 1;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
