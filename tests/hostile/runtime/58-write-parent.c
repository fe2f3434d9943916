/* Tries: to write the init's memory
 * Stopped by: the seccomp filter of the run box
 * expect: forbidden-operation, process_vm_writev */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"
#include "raw.h"

#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    struct iovec here = {&vertex_count, 4}, there = {edges, 4};
    raw(SYS_process_vm_writev, getppid(), (long)&here, 1, (long)&there);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
