/* Returns a table that malloc did not make.
 * expect: undefined-behaviour */
#include "edge-table-any.h"

#include <stddef.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    static int32_t table[1 << 16];
    (void)vertex_count;
    int64_t count = 0;
    for (size_t s = 0; s < 3 * (size_t)triangle_count && count < 1 << 15; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        if (i < j) {
            table[2 * count] = i;
            table[2 * count++ + 1] = j;
        }
    }
    *edges = table;
    return count;
}
