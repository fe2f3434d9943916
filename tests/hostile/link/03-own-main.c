/* Tries: an own main
 * Stopped by: objcopy: it becomes local
 * expect: passed */
#include "edge-table-closed.h"
#include "honest.h"

int main(void)
{
    return 0;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
