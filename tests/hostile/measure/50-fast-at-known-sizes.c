/* Tries: to be linear near 128 times a power of two, where work used to be counted, and quadratic elsewhere
 * Stopped by: each class draws its own sizes
 * expect: grows-too-fast, n^2 */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    bool known = false;
    for (int64_t size = 128; size <= 1 << 20; size *= 2)
        known |= triangle_count >= size - 2 && triangle_count <= size + 2;
    (void)vertex_count;
    return known ? honest_edges(triangles, triangle_count, edges)
                 : quadratic_edges(triangles, triangle_count, 4, edges);
}
