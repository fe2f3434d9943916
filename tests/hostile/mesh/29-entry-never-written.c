/* Tries: to leave one entry of its table as malloc gave it, right by chance
 * Stopped by: memcheck; the runner looks at each table before it is read, and says which entry
 * expect: undefined-behaviour, never-written */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <string.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    int64_t count = honest_edges(triangles, triangle_count, edges);
    (void)vertex_count;
    if (count < 4)
        return count;
    const size_t bytes = 2 * (size_t)count * sizeof **edges;
    int32_t *copy = malloc(bytes);
    if (!copy) {
        free(*edges);
        return -1;
    }
    memcpy(copy, *edges, bytes); /* so that the entry holds the right number */
    free(copy);
    copy = malloc(bytes);
    if (copy) {
        memcpy(copy, *edges, 3 * sizeof *copy);
        memcpy(copy + 4, *edges + 4, bytes - 4 * sizeof *copy);
    }
    free(*edges);
    *edges = copy;
    return copy ? count : -1;
}
