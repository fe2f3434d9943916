/* The reference's work, REPEATS times. */
#include "mesh-area.h"

double reference_once(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                      int32_t triangle_count);

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    for (int i = 1; i < REPEATS; i++)
        reference_once(vertices, vertex_count, triangles, triangle_count);
    return reference_once(vertices, vertex_count, triangles, triangle_count);
}
