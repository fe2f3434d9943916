/* Returns offsets, and NULL for the vertices.
 * expect: wrong-answer */
#include "boundary-loops.h"

#include <stdlib.h>

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    (void)triangles;
    (void)vertex_count;
    *vertices = NULL;
    *first = calloc((size_t)triangle_count + 1, sizeof **first);
    if (!*first)
        return OUT_OF_MEMORY;
    for (int32_t t = 0; t <= triangle_count; t++)
        (*first)[t] = 3 * t;
    return triangle_count;
}
