/* Tries: to end the engine by a sweep over thread ids
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, tgkill */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"
#include "raw.h"

#include <signal.h>
#include <sys/syscall.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    for (int id = 1; id < 40000; id++)
        raw(SYS_tgkill, id, id, SIGKILL, 0);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
