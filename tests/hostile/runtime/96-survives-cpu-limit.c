/* Tries: to go on after the signal of the CPU limit
 * Stopped by: the engine: CPU time
 * expect: cpu-time, cpu-limit */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <signal.h>

static volatile sig_atomic_t done;

static void go_on(int number)
{
    signal(number, go_on);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    signal(SIGXCPU, go_on);
    while (!done)
        continue;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
