/* Tries: to be looked into by others
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, prctl */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"
#include "raw.h"

#include <sys/prctl.h>
#include <sys/syscall.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    raw(SYS_prctl, PR_SET_DUMPABLE, 1, 0, 0);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
