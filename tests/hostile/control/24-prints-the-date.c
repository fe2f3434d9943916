/* Tries: to print the date and time, for which libc reads and keeps names of time zones
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdio.h>
#include <time.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    char text[64];
    time_t now = time(NULL);
    struct tm *local = localtime(&now);
    (void)vertex_count;
    if (local && strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S %Z", local) > 0)
        puts(text);
    return honest_edges(triangles, triangle_count, edges);
}
