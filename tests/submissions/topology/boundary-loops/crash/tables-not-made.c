/* Writes through *first and *vertices without making the tables. */
#include "boundary-loops.h"

#include <stddef.h>

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    (void)vertex_count;
    *first = *vertices = NULL;
    for (int32_t t = 0; t < triangle_count; t++) {
        (*first)[t + 1] = 3 * (t + 1);
        for (int32_t k = 0; k < 3; k++)
            (*vertices)[3 * t + k] = triangles[3 * t + k];
    }
    return triangle_count;
}
