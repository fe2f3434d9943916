/* Tries: to read what stands before its last table, where the one before ends
 * Stopped by: the sanitizer: each table of the input is a block of its own there
 * expect: undefined-behaviour, found */
#define _GNU_SOURCE
#include "honest.h"
#include "mesh-area.h"

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    static volatile int32_t seen;
    if (vertex_count > 0 && triangle_count > 0)
        seen = triangles[-1];
    return honest_area(vertices, triangles, triangle_count);
}
