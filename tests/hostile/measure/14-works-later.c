/* Tries: to return at once and fill the table from a timer, after the measurement
 * Stopped by: the seccomp filter of the run box, and of the tools'
 * expect: forbidden-operation, setitimer */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <signal.h>
#include <sys/time.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    signal(SIGALRM, SIG_IGN);
    struct itimerval soon = {{0, 1}, {0, 1}};
    setitimer(ITIMER_REAL, &soon, NULL);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
