/* Tries: to bind names weakly
 * Stopped by: the compiler: there is no such function in the file
 * expect: compile-error, syntax */
#include "edge-table-closed.h"
#include "honest.h"

#pragma weak measure_end = mesh_end

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
