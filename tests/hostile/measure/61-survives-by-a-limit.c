/* Tries: to survive a heap overflow under the sanitizer, whose message is past a limit of the size of files: that is a signal
 * Stopped by: the runner's second filter: a change of limits ends the program
 * expect: flagged, behaves-differently */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"
#include "survive.h"

#include <sys/resource.h>

static void lower_limit(void)
{
    struct rlimit limit;
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = 0;
    setrlimit(RLIMIT_FSIZE, &limit);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    if (under_sanitizer())
        lower_limit(), overflow(SIGXFSZ);
    return honest_edges(triangles, triangle_count, edges);
}
