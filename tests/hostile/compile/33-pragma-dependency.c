/* Tries: to learn of files and their ages
 * Stopped by: the build box: the file is not there
 * expect: compile-error, syntax */
#include "edge-table-closed.h"
#include "honest.h"

#pragma GCC dependency "/etc/passwd"

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
