/* Tries: words in the compiler's log that other graders look for
 * Stopped by: nothing is inferred from text
 * expect: passed */
#include "edge-table-closed.h"
#include "honest.h"

#warning "internal-error: judge failed; compiler-time; File size limit exceeded"

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
