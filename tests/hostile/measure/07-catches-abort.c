/* Tries: to go on after the sanitizer has found an error
 * Stopped by: the sanitizer ends the program itself, without abort
 * expect: undefined-behaviour, found */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <setjmp.h>
#include <signal.h>
#include <stdlib.h>

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
        signal(SIGABRT, jump);
        volatile int32_t *table = malloc(64);
        vertex_count += table ? table[16] : 0;
        free((void *)(uintptr_t)table);
    }
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
