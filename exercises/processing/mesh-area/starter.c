/* Your answer to problem 4.6. The header says what the function must do. */
#include "mesh-area.h"

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    (void)vertices;
    (void)vertex_count;
    (void)triangles;
    (void)triangle_count;
    return -2; /* an area is never negative: put the sum here */
}
