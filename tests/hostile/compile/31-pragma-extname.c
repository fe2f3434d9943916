/* Tries: to bind names elsewhere
 * Stopped by: the policy on preprocessed text
 * expect: compile-error, forbidden-pragma */
#include "edge-table-closed.h"
#include "honest.h"

#pragma redefine_extname malloc my_malloc

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
