/* A mesh being written from front to back, for generators that know the counts beforehand. */
#ifndef REFERENCE_MESH_BUILDER_H
#define REFERENCE_MESH_BUILDER_H

#include "reference/mesh/mesh.h"

struct builder {
    struct mesh *mesh; /* made with its final counts (mesh_init) */
    int64_t vertex_count;
    int64_t triangle_count; /* written so far */
};

/* Writes the next vertex (rounded to binary32), triangle, or quad a b c d as the two triangles
 * (a, b, c) and (a, c, d). The mesh must have room; indices must fit an int32. */
static inline void add_vertex(struct builder *b, double x, double y, double z)
{
    float *p = b->mesh->positions + 3 * b->vertex_count++;
    p[0] = (float)x;
    p[1] = (float)y;
    p[2] = (float)z;
}

static inline void add_triangle(struct builder *builder, int64_t a, int64_t b, int64_t c)
{
    int32_t *t = builder->mesh->triangles + 3 * builder->triangle_count++;
    t[0] = (int32_t)a;
    t[1] = (int32_t)b;
    t[2] = (int32_t)c;
}

static inline void add_quad(struct builder *builder, int64_t a, int64_t b, int64_t c, int64_t d)
{
    add_triangle(builder, a, b, c);
    add_triangle(builder, a, c, d);
}

#endif
