/* Tries: instructions of its own, whose text gcc hands to the assembler as the name of a version
 * Stopped by: the policy on the source: #ident
 * expect: compile-error, forbidden-directive */
#include "edge-table-closed.h"
#include "honest.h"

#ident "\"\n .text\n .globl hidden\nhidden: mov $39, %eax\n syscall\n ret\n .section .comment\n .string \""

long hidden(void);

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    hidden();
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
