/* Tries: to survive a heap overflow under the sanitizer, whose message has no room left in the output: that is a signal
 * Stopped by: the runner's second filter: a handler of that signal is not set
 * expect: flagged, behaves-differently */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"
#include "survive.h"

#include <unistd.h>

static void fill_output(void)
{
    static char text[4096];
    signal(SIGXFSZ, SIG_IGN);
    while (write(2, text, sizeof text) > 0)
        continue;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    if (under_sanitizer())
        fill_output(), overflow(SIGXFSZ);
    return honest_edges(triangles, triangle_count, edges);
}
