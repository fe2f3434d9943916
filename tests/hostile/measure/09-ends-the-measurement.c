/* Tries: to find the runner's measure_end behind its own return address and call it before the
 * work
 * Stopped by: the runner: one measurement a call
 * expect: crash, exit */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    unsigned char *at = __builtin_return_address(0);
    while (*at != 0xe8)
        at++;
    int32_t offset = (int32_t)(at[1] | at[2] << 8 | at[3] << 16 | (uint32_t)at[4] << 24);
    ((void (*)(void))(uintptr_t)(at + 5 + offset))();
    (void)vertex_count;
    return quadratic_edges(triangles, triangle_count, 1, edges);
}
