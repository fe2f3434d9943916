/* Tries: to read past its first table, under memcheck only
 * Stopped by: memcheck: each table of the input is a block of its own there
 * expect: undefined-behaviour, found */
#define _GNU_SOURCE
#include "honest.h"
#include "mesh-area.h"

double mesh_area(const float *vertices, int32_t vertex_count, const int32_t *triangles,
                 int32_t triangle_count)
{
    static volatile float seen;
    if (under_memcheck() && vertex_count > 0)
        seen = vertices[3 * (size_t)vertex_count];
    return honest_area(vertices, triangles, triangle_count);
}
