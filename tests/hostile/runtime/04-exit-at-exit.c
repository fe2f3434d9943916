/* Tries: to write an answer while exiting
 * Stopped by: exits are no answers: the nonce was not echoed
 * expect: crash, exit */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdio.h>
#include <stdlib.h>

static void late(void)
{
    puts("PASSED");
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    atexit(late);
    exit(0);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
