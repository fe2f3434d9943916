/* Tries: to switch the sanitizer's exit code off
 * Stopped by: the screen of the object: names of the sanitizers
 * expect: compile-error, sanitizer-symbol */
#include "edge-table-closed.h"
#include "honest.h"

const char *__asan_default_options(void);

const char *__asan_default_options(void)
{
    return "exitcode=0:detect_leaks=0";
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
