/* Tries: infinity
 * Stopped by: the judge
 * expect: wrong-answer, not-a-number */
#define _GNU_SOURCE
#include "mesh-area.h"

#include <math.h>

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertices;
    (void)vertex_count;
    (void)triangles;
    return triangle_count > 0 ? INFINITY : 0;
}
