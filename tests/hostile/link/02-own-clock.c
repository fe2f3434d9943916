/* Tries: a clock that stands still
 * Stopped by: objcopy, and the engine reads clocks of its own
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <time.h>

int clock_gettime(clockid_t clock, struct timespec *time)
{
    (void)clock;
    *time = (struct timespec){0, 0};
    return 0;
}

time_t time(time_t *now)
{
    if (now)
        *now = 0;
    return 0;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
