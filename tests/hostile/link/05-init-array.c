/* Tries: the same by a pointer in a section
 * Stopped by: the policy on preprocessed text
 * expect: compile-error, forbidden-attribute */
#include "edge-table-closed.h"
#include "honest.h"

#include <unistd.h>

static void early(void)
{
    _exit(0);
}

__attribute__((section(".preinit_array"), used)) static void (*const entry)(void) = early;

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
