/* Tries: macros for names that the runner and the judge use
 * Stopped by: separate translation units: they hide nothing but the student's own text
 * expect: passed */
#include "edge-table-closed.h"
#include "honest.h"

#define main no_main
#define run_call no_call
#define measure_begin() 0
#define assert(x) 0
#define free(x) 0

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
