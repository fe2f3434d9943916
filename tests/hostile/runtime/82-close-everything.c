/* Tries: to close the descriptors under the runner
 * Stopped by: the regions are mapped already; the answer is right
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    for (int file = 0; file < 1024; file++)
        close(file);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
