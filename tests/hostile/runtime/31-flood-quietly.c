/* Tries: the same, ignoring the signal that would end it
 * Stopped by: the largest file of the box: write fails, and the answer is right; under the sanitizer no signal
 *     but a program's own faults can be ignored, so the program ends there
 * expect: flagged, behaves-differently */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <signal.h>
#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static const char block[4096];
    signal(SIGXFSZ, SIG_IGN);
    while (write(1, block, sizeof block) > 0)
        continue;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
