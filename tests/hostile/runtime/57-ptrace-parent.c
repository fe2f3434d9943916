/* Tries: to take over the box's init
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, ptrace */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"
#include "raw.h"

#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    raw(SYS_ptrace, PTRACE_ATTACH, getppid(), 0, 0);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
