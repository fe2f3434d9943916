/* Tries: to run without being interrupted
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, sched_setscheduler */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <sched.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    struct sched_param first = {99};
    sched_setscheduler(0, SCHED_FIFO, &first);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
