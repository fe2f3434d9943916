/* Tries: the right number with the wrong sign
 * Stopped by: the judge
 * expect: wrong-answer, negative-area */
#define _GNU_SOURCE
#include "honest.h"
#include "mesh-area.h"

#include <math.h>

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    return -honest_area(vertices, triangles, triangle_count);
}
