/* Tries: to end under the tools as by somebody outside
 * Stopped by: the seccomp filter of the tools' box: only the signals of a crash, to itself
 * expect: flagged, behaves-differently */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <signal.h>
#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (under_sanitizer() || under_memcheck())
        _exit(raise(SIGTERM));
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
