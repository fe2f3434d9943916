/* Tries: to leave the sanitizer by an attribute that no search of the source finds
 * Stopped by: the policy on preprocessed text
 * expect: compile-error, forbidden-attribute */
#include "edge-table-closed.h"
#include "honest.h"

#define PASTE(a, b) a##b
#define QUIET __attribute__((PASTE(no_, sanitize)("address")))

QUIET int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
