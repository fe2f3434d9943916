/* Tries: text that the policy and the compiler would read differently
 * Stopped by: the policy: raw strings are no C
 * expect: compile-error, raw-string */
#include "edge-table-closed.h"
#include "honest.h"

static const char *const text = R"(" __attribute__((constructor)) ")";

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)text;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
