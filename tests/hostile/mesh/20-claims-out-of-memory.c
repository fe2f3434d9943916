/* Tries: to blame the memory
 * Stopped by: the allocation shim: every request was granted
 * expect: wrong-answer, claims-out-of-memory */
#define _GNU_SOURCE
#include "edge-table-closed.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    (void)edges;
    return OUT_OF_MEMORY;
}
