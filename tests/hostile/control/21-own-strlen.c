/* Tries: functions of its own that are named like libc's and like the runner's
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdio.h>

size_t strlen(const char *text);
static int run_call;

__attribute__((noinline)) size_t strlen(const char *text)
{
    size_t count = 0;
    while (text[count])
        count++;
    return count;
}

/* The name by which callgrind is told when to dump. */
__attribute__((noinline)) static void counted_call_ends(void)
{
    run_call++;
}

__attribute__((noinline)) void measure_begin(void);
void measure_begin(void)
{
    run_call = 0;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    for (size_t i = 0; i < strlen("edges"); i++)
        counted_call_ends();
    printf("%zu %d\n", strlen("edges"), run_call);
    measure_begin();
    return honest_edges(triangles, triangle_count, edges);
}
