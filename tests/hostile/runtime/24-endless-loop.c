/* Tries: to run for ever, with all signals blocked
 * Stopped by: the engine: CPU time
 * expect: cpu-time, cpu-limit */
#define _GNU_SOURCE
#include "edge-table-closed.h"

#include <signal.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, NULL);
    for (volatile int i = 0;; i++)
        continue;
}
