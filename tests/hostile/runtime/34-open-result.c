/* Tries: to write the result itself
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, creat */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <fcntl.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    creat("results.json", 0666);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
