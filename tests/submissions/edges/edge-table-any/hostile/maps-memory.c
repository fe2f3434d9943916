/* Gets memory that the allocator does not know.
 * expect: compile-error */
#define _GNU_SOURCE
#include "edge-table-any.h"

#include <stddef.h>
#include <sys/mman.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *edges = mmap(NULL, 1 << 24, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return 0;
}
