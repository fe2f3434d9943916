/* Tries: a variable that is merged with one of the same name elsewhere
 * Stopped by: the policy on preprocessed text: only listed attributes
 * expect: compile-error, forbidden-attribute */
#include "edge-table-closed.h"
#include "honest.h"

__attribute__((common)) int64_t shim_counts[6];

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    shim_counts[3] = 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
