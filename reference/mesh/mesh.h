/* The indexed triangle mesh, as the course defines it: a table of vertex positions and a table of
 * triangles that name their vertices by index.
 *
 * Invariants of a valid mesh (mesh_check): every index is in [0, vertex_count); every coordinate is
 * finite. Nothing else is promised: triangles may be degenerate or listed twice, vertices isolated,
 * edges non-manifold. Outside is where a triangle is seen counter-clockwise.
 *
 * Bytes: 12 a vertex (three binary32) and 12 a triangle (three int32). */
#ifndef REFERENCE_MESH_MESH_H
#define REFERENCE_MESH_MESH_H

#include "reference/base/error.h"

#include <stdint.h>

struct mesh {
    float *positions;   /* 3 * vertex_count coordinates: x y z of vertex 0, then of vertex 1, ... */
    int32_t *triangles; /* 3 * triangle_count indices, 0-based */
    int32_t vertex_count;
    int32_t triangle_count;
};

/* Makes a mesh with room for the given tables, all zero. The zero value is a valid empty mesh.
 *
 * mesh     its old contents are not looked at; on success the caller owns it (mesh_release)
 * counts   0 ... INT32_MAX / 3; more is an error, so that 3 * count fits an int32
 * returns  0, or -1 and *err */
int mesh_init(struct mesh *mesh, int64_t vertex_count, int64_t triangle_count,
              struct error *err) MUST_CHECK;

/* Frees the tables and leaves the empty mesh. A zeroed mesh may be released, any number of times.
 */
void mesh_release(struct mesh *mesh);

/* Copies `from` into `to`, which the caller owns afterwards. Returns 0, or -1 and *err. */
int mesh_copy(struct mesh *to, const struct mesh *from, struct error *err) MUST_CHECK;

/* Checks the invariants above. Returns 0, or -1 and *err naming the triangle or vertex at fault. */
int mesh_check(const struct mesh *mesh, struct error *err) MUST_CHECK;

/* Bytes of the two tables: 12 a vertex and 12 a triangle. */
int64_t mesh_bytes(int64_t vertex_count, int64_t triangle_count);

#endif
