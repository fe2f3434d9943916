/* Waits for a thousand seconds.
 * expect: idle-time */
#include "edge-table-any.h"

#include <stddef.h>
#include <time.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *edges = NULL;
    struct timespec thousand_seconds = {1000, 0};
    nanosleep(&thousand_seconds, NULL);
    return 0;
}
