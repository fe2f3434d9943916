/* Tries: to turn the clock back
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, clock_settime */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <time.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    struct timespec zero = {0, 0};
    clock_settime(CLOCK_REALTIME, &zero);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
