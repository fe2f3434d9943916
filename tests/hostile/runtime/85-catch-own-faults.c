/* Tries: to survive its own crash by a handler, and answer right
 * Stopped by: the sanitizers, whose handler cannot be replaced
 * expect: undefined-behaviour, found */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <setjmp.h>
#include <signal.h>

static sigjmp_buf back;

static void jump(int number)
{
    (void)number;
    siglongjmp(back, 1);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (sigsetjmp(back, 1) == 0) {
        signal(SIGSEGV, jump);
        *(volatile int *)(uintptr_t)triangle_count = 1;
    }
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
