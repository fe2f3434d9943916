/* Returns a count, and NULL for both tables.
 * expect: wrong-answer */
#include "boundary-loops.h"

#include <stdlib.h>

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    (void)triangles;
    (void)vertex_count;
    *first = *vertices = NULL;
    return triangle_count;
}
