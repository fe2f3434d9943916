/* Tries: to measure or sample other processes
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, perf_event_open */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"
#include "raw.h"

#include <sys/syscall.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    raw(SYS_perf_event_open, 0, 0, -1, -1);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
