/* Returns one block as both tables: it is freed twice.
 * expect: undefined-behaviour */
#include "boundary-loops.h"

#include <stdlib.h>

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    (void)triangles;
    (void)vertex_count;
    *first = *vertices = calloc(4, sizeof **first);
    if (!*first)
        return OUT_OF_MEMORY;
    (*first)[1] = 3;
    return triangle_count > 0;
}
