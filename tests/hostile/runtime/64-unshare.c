/* Tries: capabilities in a namespace of its own
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, unshare */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"
#include "raw.h"

#include <sched.h>
#include <sys/syscall.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    raw(SYS_unshare, CLONE_NEWUSER, 0, 0, 0);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
