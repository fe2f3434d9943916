/* The last offset lies far outside the vertices.
 * expect: wrong-answer */
#include "boundary-loops.h"

#include <stdlib.h>

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *first = malloc(2 * sizeof **first);
    *vertices = calloc(3, sizeof **vertices);
    if (!*first || !*vertices) {
        free(*first);
        free(*vertices);
        return OUT_OF_MEMORY;
    }
    (*first)[0] = 0;
    (*first)[1] = INT32_MAX;
    return 1;
}
