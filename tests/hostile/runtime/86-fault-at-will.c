/* Tries: to pass its own end off as a fault of the grader's, by the page that it shares with the
 * engine and the runner's exit code for missing memory
 * Stopped by: the engine knows from before the first call that the runner had its memory
 * expect: crash, exit */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static const char nothing[512];
    (void)!pwrite(3, nothing, sizeof nothing, 128);
    _exit(99);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
