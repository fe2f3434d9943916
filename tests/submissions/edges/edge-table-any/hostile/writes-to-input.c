/* Sorts the corners of the triangles in place, although they are const.
 * expect: crash */
#include "edge-table-any.h"

#include <stddef.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)vertex_count;
    *edges = NULL;
    int32_t *writable = (int32_t *)(uintptr_t)triangles;
    for (int64_t t = 0; t < triangle_count; t++)
        if (writable[3 * t] > writable[3 * t + 1]) {
            int32_t kept = writable[3 * t];
            writable[3 * t] = writable[3 * t + 1];
            writable[3 * t + 1] = kept;
        }
    return 0;
}
