/* Tries: to type into the person's terminal
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, ioctl */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <sys/ioctl.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    char byte = 'x';
    ioctl(0, TIOCSTI, &byte);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
