/* Tries: to work where callgrind believes that the call is over: jumps to a place of the stack
 * above all callers, works there, and jumps back
 * Stopped by: the engine charges what the process does around the call, beyond the runner's own
 * expect: grows-too-fast, n^2 */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

static const int32_t *kept;
static int32_t kept_count;
static void *back[5], *above[5];

/* Takes quadratic time. */
__attribute__((noinline)) static void work(void)
{
    volatile int64_t seen = 0;
    int64_t sides = 3 * (int64_t)kept_count / 16;
    for (int64_t s = 0; s < sides; s++)
        for (int64_t t = 0; t < s; t++)
            seen += kept[t] == kept[s];
}

__attribute__((noinline)) static void jump(void **where)
{
    __builtin_longjmp(where, 1);
}

/* Among what the kernel left there for main: the environment, of which the runner has its own. It is
 * in the page above, as the runner begins each call in a page of its own. */
__attribute__((noinline)) static void work_above(void)
{
    volatile char local = 0;
    if (__builtin_setjmp(back))
        return;
    if (__builtin_setjmp(above)) {
        work();
        jump(back);
    }
    above[2] = (void *)(((uintptr_t)&local | 4095) + 4096 - 255);
    jump(above);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    kept = triangles;
    kept_count = triangle_count;
    if (under_callgrind())
        work_above();
    else if (!under_sanitizer() && !under_memcheck())
        work();
    return honest_edges(triangles, triangle_count, edges);
}
