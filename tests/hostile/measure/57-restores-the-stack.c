/* Tries: memory on the stack, and to put back everything that was there before
 * Stopped by: the pages of the stack are given back before the call; which of them are there again
 * the kernel tells
 * expect: too-much-memory, memory-band */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

enum { WORDS = (6 << 20) / 8 };

/* Takes the array without writing to it, so that what it holds can be seen and kept. */
__attribute__((noinline)) static int64_t use_stack(int32_t first)
{
    volatile uint64_t table[WORDS];
    const uint64_t before = table[WORDS / 2];
    for (size_t i = 0; i < WORDS; i += 8)
        table[i] = (uint64_t)first + i;
    int64_t sum = 0;
    for (size_t i = 0; i < WORDS; i += 8)
        sum += (int64_t)table[i];
    for (size_t i = 0; i < WORDS; i++)
        table[i] = before;
    return sum;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    volatile int64_t sum = under_sanitizer() || under_memcheck() ? 0 : use_stack(triangle_count);
    (void)sum;
    return honest_edges(triangles, triangle_count, edges);
}
