/* Tries: numbers in long double, which valgrind cuts to double
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "honest.h"
#include "mesh-area.h"

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    long double sum = 0;
    (void)vertex_count;
    for (int32_t t = 0; t < triangle_count; t++)
        sum += honest_triangle(vertices, triangles + 3 * (size_t)t);
    return (double)sum;
}
