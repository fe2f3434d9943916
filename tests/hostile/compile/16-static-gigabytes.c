/* Tries: 8 GiB that no file shows
 * Stopped by: the screen of the object: static data
 * expect: compile-error, static-data */
#include "edge-table-closed.h"
#include "honest.h"

static volatile char large[1L << 33];

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    large[triangle_count] = 1;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
