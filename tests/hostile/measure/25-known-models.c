/* Tries: answers for the meshes that it knows by their counts; one edge for the others
 * Stopped by: every class is judged on meshes of every count
 * expect: wrong-answer, missing-edge */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (triangle_count == 4 || triangle_count == 12 || triangle_count == 20 ||
        triangle_count == 320)
        return honest_edges(triangles, triangle_count, edges);
    (void)vertex_count;
    *edges = malloc(2 * sizeof **edges);
    if (!*edges)
        return OUT_OF_MEMORY;
    (*edges)[0] = triangle_count > 0 ? triangles[0] : 0;
    (*edges)[1] = triangle_count > 0 ? triangles[1] : 0;
    return triangle_count > 0;
}
