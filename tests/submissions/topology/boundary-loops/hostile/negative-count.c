/* Returns a count below zero.
 * expect: wrong-answer */
#include "boundary-loops.h"

#include <stdlib.h>

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *first = *vertices = NULL;
    return INT32_MIN;
}
