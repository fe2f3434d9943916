/* Tries: to end under the tools by a signal that it may not send
 * Stopped by: the engine knows which signals a program's own doing can bring
 * expect: flagged, behaves-differently */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    int ends[2];
    if ((under_sanitizer() || under_memcheck()) && pipe(ends) == 0 && close(ends[0]) == 0)
        (void)!write(ends[1], ends, sizeof ends);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
