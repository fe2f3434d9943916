/* Tries: the same with a function of the sanitizer's
 * Stopped by: the screen of the object: names of the sanitizers
 * expect: compile-error, sanitizer-symbol */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

void __asan_poison_memory_region(const void *, size_t) __attribute__((weak));

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (__asan_poison_memory_region)
        return honest_edges(triangles, triangle_count, edges);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
