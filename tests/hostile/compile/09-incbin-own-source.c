/* Tries: the same with a file that is there
 * Stopped by: the policy on preprocessed text
 * expect: compile-error, inline-assembly */
#include "edge-table-closed.h"
#include "honest.h"

__asm__(".section .note.source\n.incbin \"edge-table-closed.h\"\n.text");

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
