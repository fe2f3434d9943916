/* Tries: to run where the reference does not
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, sched_setaffinity */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"
#include "raw.h"

#include <sched.h>
#include <string.h>
#include <sys/syscall.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    cpu_set_t all;
    memset(&all, 0xff, sizeof all);
    raw(SYS_sched_setaffinity, 0, sizeof all, (long)&all, 0);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
