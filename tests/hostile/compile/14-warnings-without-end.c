/* Tries: 2^18 warnings: a flood of diagnostics; the answer behind it is right
 * Stopped by: the cap on diagnostics
 * expect: passed */
#include "edge-table-closed.h"
#include "honest.h"

#define A _Pragma("GCC warning \"x\"")
#define B A A A A A A A A
#define C B B B B B B B B
#define D C C C C C C C C
D D D D

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
