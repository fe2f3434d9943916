/* Tries: the code for missing memory as an area
 * Stopped by: no memory was refused
 * expect: wrong-answer, claims-out-of-memory */
#define _GNU_SOURCE
#include "mesh-area.h"

#include <math.h>

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertices;
    (void)vertex_count;
    (void)triangles;
    (void)triangle_count;
    return OUT_OF_MEMORY;
}
