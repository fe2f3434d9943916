/* Tries: quadratic work once, then from memory when the same mesh comes again
 * Stopped by: each call brings another mesh
 * expect: grows-too-fast, n^2 */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

static uint64_t known;

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    uint64_t hash = 14695981039346656037u;
    for (int64_t s = 0; s < 3 * (int64_t)triangle_count; s++)
        hash = (hash ^ (uint32_t)triangles[s]) * 1099511628211u;
    if (hash == known)
        return honest_edges(triangles, triangle_count, edges);
    known = hash;
    (void)vertex_count;
    return quadratic_edges(triangles, triangle_count, 1, edges);
}
