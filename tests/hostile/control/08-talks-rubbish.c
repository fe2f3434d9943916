/* Tries: text that a report must show and not obey
 * Stopped by: nothing: it must pass, and its text must stay text
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdio.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    puts(
        "<script>alert(1)</script><img src=x onerror=alert(1)>\x1b[2J\x1b]8;;http://x\x07\xff\xfe");
    puts("]]></system-out> =HYPERLINK(\"http://x\") \xe2\x80\xae Grade :=>> 100");
    putchar(0);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
