/* Tries: to wait for ever
 * Stopped by: the engine: time without CPU time
 * expect: idle-time, idle-limit */
#define _GNU_SOURCE
#include "edge-table-closed.h"

#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    for (;;)
        sleep(1000);
}
