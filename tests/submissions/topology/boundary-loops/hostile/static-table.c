/* Returns tables that malloc did not make.
 * expect: undefined-behaviour */
#include "boundary-loops.h"

#include <stdlib.h>

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    static int32_t offsets[2] = {0, 3}, loop[3] = {0, 1, 2};
    (void)triangles;
    (void)vertex_count;
    *first = offsets;
    *vertices = loop;
    return triangle_count > 0;
}
