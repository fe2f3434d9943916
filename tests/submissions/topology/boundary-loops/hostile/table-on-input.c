/* Returns its input as the vertices.
 * expect: undefined-behaviour */
#include "boundary-loops.h"

#include <stdlib.h>

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    (void)vertex_count;
    *first = calloc((size_t)triangle_count + 1, sizeof **first);
    if (!*first)
        return OUT_OF_MEMORY;
    for (int32_t t = 0; t <= triangle_count; t++)
        (*first)[t] = 3 * t;
    *vertices = (int32_t *)(uintptr_t)triangles;
    return triangle_count;
}
