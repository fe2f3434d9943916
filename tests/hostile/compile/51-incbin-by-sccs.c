/* Tries: to put a file into the program by the other directive of this kind, written with a digraph and a joined line
 * Stopped by: the policy on the source: #sccs
 * expect: compile-error, forbidden-directive */
#include "edge-table-closed.h"
#include "honest.h"

%: sc\
cs "\"\n .data\n .globl hidden\nhidden: .incbin \"edge-table-closed.h\"\n .section .comment\n .string \""

extern const char hidden[];

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (hidden[0] == 1)
        return -7;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
