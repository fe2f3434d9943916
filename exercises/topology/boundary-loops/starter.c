/* Your answer. The header says what the function must do. */
#include "boundary-loops.h"

#include <stdlib.h>

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *first = NULL; /* make the two tables with malloc */
    *vertices = NULL;
    return 0; /* and return how many loops they hold */
}
