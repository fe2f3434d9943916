/* A mesh of unknown size that grows while a file is read. Memory follows what was read, never what
 * a header claims. */
#ifndef REFERENCE_FORMATS_GROWING_MESH_H
#define REFERENCE_FORMATS_GROWING_MESH_H

#include "reference/mesh/mesh.h"

#include <string.h>

struct growing_mesh {
    float *positions;
    int32_t *triangles;
    int64_t vertex_count, vertex_capacity;
    int64_t triangle_count, triangle_capacity;
};

/* Doubles the room for vertices (triangles). Return 0, or -1 and *err (out of memory, or more than
 * INT32_MAX / 3 elements). */
int growing_mesh_grow_vertices(struct growing_mesh *mesh, struct error *err) MUST_CHECK;
int growing_mesh_grow_triangles(struct growing_mesh *mesh, struct error *err) MUST_CHECK;

/* Append an element, by doubling the room when there is none; return as the above. */
MUST_CHECK static inline int growing_mesh_add_vertex(struct growing_mesh *mesh,
                                                     const float position[3], struct error *err)
{
    if (mesh->vertex_count == mesh->vertex_capacity && growing_mesh_grow_vertices(mesh, err))
        return -1;
    memcpy(mesh->positions + 3 * mesh->vertex_count++, position, 3 * sizeof *position);
    return 0;
}

MUST_CHECK static inline int growing_mesh_add_triangle(struct growing_mesh *mesh, int32_t a,
                                                       int32_t b, int32_t c, struct error *err)
{
    if (mesh->triangle_count == mesh->triangle_capacity && growing_mesh_grow_triangles(mesh, err))
        return -1;
    int32_t *corner = mesh->triangles + 3 * mesh->triangle_count++;
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
    return 0;
}

/* Makes room beforehand for counts that the file's size was found to allow. Return 0, or -1 and
 * *err (out of memory). */
int growing_mesh_reserve(struct growing_mesh *mesh, int64_t vertex_count, int64_t triangle_count,
                         struct error *err) MUST_CHECK;

/* A polygon that arrives corner by corner, cut into a fan around its first corner. Start with zero.
 */
struct polygon {
    int64_t corner_count;
    int32_t first, last;
};
int polygon_add_corner(struct polygon *polygon, struct growing_mesh *mesh, int32_t vertex,
                       struct error *err) MUST_CHECK;

/* Moves the tables, cut to their size, into `to`, which the caller owns; leaves a zeroed object.
 * Cannot fail. */
void growing_mesh_finish(struct growing_mesh *mesh, struct mesh *to);

/* Frees what is there; a zeroed object may be released. */
void growing_mesh_release(struct growing_mesh *mesh);

#endif
