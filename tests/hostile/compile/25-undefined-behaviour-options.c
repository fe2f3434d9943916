/* Tries: the same for the other sanitizer
 * Stopped by: the screen of the object: names of the sanitizers
 * expect: compile-error, sanitizer-symbol */
#include "edge-table-closed.h"
#include "honest.h"

const char *__ubsan_default_options(void);

const char *__ubsan_default_options(void)
{
    return "halt_on_error=0:exitcode=0";
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
