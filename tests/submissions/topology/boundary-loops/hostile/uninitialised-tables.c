/* Returns tables that it never fills.
 * expect: undefined-behaviour */
#include "boundary-loops.h"

#include <stdlib.h>

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    (void)triangles;
    (void)vertex_count;
    *first = malloc(((size_t)triangle_count + 1) * sizeof **first);
    *vertices = malloc(3 * (size_t)triangle_count * sizeof **vertices + 1);
    if (*first && *vertices)
        return triangle_count;
    free(*first);
    free(*vertices);
    return OUT_OF_MEMORY;
}
