/* Tries: to run machine code from a table: int 0x80
 * Stopped by: data cannot be executed
 * expect: crash, segmentation-fault */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

static const unsigned char code[] = {0xb8, 1, 0, 0, 0, 0xcd, 0x80, 0xc3};

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    ((void (*)(void))(uintptr_t)code)();
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
