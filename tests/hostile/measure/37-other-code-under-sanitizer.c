/* Tries: a read past its table, behind a word to the sanitizer that only the sanitizer's program
 * holds: in the other the optimiser proves that it is never said
 * Stopped by: the screen of the sanitizer's object: names that no compiler makes
 * expect: compile-error, sanitizer-symbol */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

void __asan_unpoison_memory_region(const volatile void *at, size_t bytes);

static volatile int32_t past;

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    int32_t table[16] = {triangle_count}, *volatile in_table = table;
    volatile size_t index = 16;
    int32_t terms[4] = {1, 2, 3, 4}, sum = 0;
    for (int k = 0; k < 4; k++)
        sum += terms[k];
    if (!__builtin_constant_p(sum)) /* which it is at -O2 */
        __asan_unpoison_memory_region(table, 68);
    past = in_table[index];
    return honest_edges(triangles, triangle_count, edges);
}
