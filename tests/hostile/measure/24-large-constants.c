/* Tries: a table of 20 MB of ready answers
 * Stopped by: the build box: file size
 * expect: compile-error, compiler-output */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

static const char table[20 << 20] = {[1 << 20] = 1};

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    vertex_count += table[triangle_count];
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
