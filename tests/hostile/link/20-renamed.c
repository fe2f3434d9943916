/* Tries: the function under another name
 * Stopped by: the screen of the object
 * expect: compile-error, missing-function */
#include "edge-table-closed.h"
#include "honest.h"

int64_t edge_table(const int32_t *triangles, int32_t triangle_count, int32_t **edges);

int64_t edge_table(const int32_t *triangles, int32_t triangle_count, int32_t **edges)
{
    return honest_edges(triangles, triangle_count, edges);
}
