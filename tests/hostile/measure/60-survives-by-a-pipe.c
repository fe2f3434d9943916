/* Tries: to survive a heap overflow under the sanitizer, whose message goes to a pipe that nobody reads: that is a signal
 * Stopped by: the runner's second filter: a handler of that signal is not set
 * expect: flagged, behaves-differently */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"
#include "survive.h"

#include <unistd.h>

static void break_stderr(void)
{
    int ends[2];
    if (pipe(ends) == 0) {
        close(ends[0]);
        dup2(ends[1], 2);
    }
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    if (under_sanitizer())
        break_stderr(), overflow(SIGPIPE);
    return honest_edges(triangles, triangle_count, edges);
}
