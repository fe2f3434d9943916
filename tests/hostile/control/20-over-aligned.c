/* Tries: types that want 64 bytes of alignment, on the stack, static and allocated
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>
#include <string.h>

struct line {
    _Alignas(64) int32_t entry[16];
};
static struct line last;

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    struct line local = {{0}}, *own = aligned_alloc(_Alignof(struct line), 4 * sizeof *own);
    if (!own)
        return -1;
    for (int i = 0; i < 4; i++)
        own[i].entry[i] = vertex_count;
    local.entry[3] = own[3].entry[3];
    last = local;
    free(own);
    return last.entry[3] == vertex_count ? honest_edges(triangles, triangle_count, edges) : -7;
}
