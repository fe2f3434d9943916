/* Tries: an answer that it made before for the same address
 * Stopped by: each call brings another mesh, paired runs to the same address
 * expect: wrong-answer, extra-edge */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>
#include <string.h>

enum { ROOM = 1 << 16 };
static const int32_t *known;
static int32_t kept[2 * ROOM];
static int64_t kept_count;

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (known == triangles) {
        *edges = malloc(2 * (size_t)kept_count * sizeof **edges + 1);
        if (!*edges)
            return OUT_OF_MEMORY;
        memcpy(*edges, kept, 2 * (size_t)kept_count * sizeof **edges);
        return kept_count;
    }
    (void)vertex_count;
    int64_t count = honest_edges(triangles, triangle_count, edges);
    if (count > 0 && count <= ROOM) {
        memcpy(kept, *edges, 2 * (size_t)count * sizeof **edges);
        kept_count = count;
        known = triangles;
    }
    return count;
}
