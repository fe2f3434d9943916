/* Takes all the memory there is, and writes to it.
 * expect: out-of-memory */
#include "edge-table-any.h"

#include <stdlib.h>
#include <string.h>

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *edges = NULL;
    char *block;
    while ((block = malloc(1 << 20)) != NULL)
        memset(block, 1, 1 << 20);
    return OUT_OF_MEMORY;
}
