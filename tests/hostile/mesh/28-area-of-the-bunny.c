/* Tries: the same number for every large mesh
 * Stopped by: every model is another
 * expect: wrong-answer, wrong-area */
#define _GNU_SOURCE
#include "honest.h"
#include "mesh-area.h"

#include <math.h>

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertex_count;
    return triangle_count > 1000 ? 0.0571 : honest_area(vertices, triangles, triangle_count);
}
