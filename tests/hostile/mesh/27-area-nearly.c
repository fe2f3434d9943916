/* Tries: an area that is wrong in the sixth digit
 * Stopped by: the judge's tolerance
 * expect: wrong-answer, wrong-area */
#define _GNU_SOURCE
#include "honest.h"
#include "mesh-area.h"

#include <math.h>

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    return 1.000002 * honest_area(vertices, triangles, triangle_count);
}
