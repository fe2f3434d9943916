/* Tries: 7 MB of stack by alloca, all of it used, on the smallest mesh
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <alloca.h>
#include <string.h>

__attribute__((noinline)) static int use_stack(size_t bytes)
{
    unsigned char *volatile block = alloca(bytes);
    memset(block, 7, bytes);
    return block[0] == 7 && block[bytes - 1] == 7;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (triangle_count == 4 && !use_stack(7 << 20))
        return 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
