/* Tries: a request to valgrind in its own code: stop counting
 * Stopped by: the policy on preprocessed text: no assembly
 * expect: compile-error, inline-assembly */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    __asm__ volatile(
        "rolq $3, %rdi; rolq $13, %rdi; rolq $61, %rdi; rolq $51, %rdi; xchgq %rbx, %rbx");
    (void)vertex_count;
    return quadratic_edges(triangles, triangle_count, 1, edges);
}
