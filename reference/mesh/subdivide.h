/* Subdivision: the same surface, or a smoother one, from more triangles. It makes meshes of any
 * size out of real models.
 *
 * Both work in place on a valid mesh that the caller owns. Orientation, boundary loops and the
 * Euler characteristic stay. Edges with more than two triangles, incoherent orientation and
 * isolated vertices are fine; a degenerate triangle is refused, since it has no edges to split.
 *
 * returns  0, or -1 and *err (out of memory, too many elements, a degenerate triangle); then the
 *          mesh is as it was
 * cost     linear in the mesh made; meanwhile also 60 bytes a triangle of the mesh given */
#ifndef REFERENCE_MESH_SUBDIVIDE_H
#define REFERENCE_MESH_SUBDIVIDE_H

#include "reference/mesh/mesh.h"

/* Splits every edge in `parts` (1 ... 30000) and every triangle in parts^2 flat ones, row by row;
 * 2 is midpoint subdivision:
 *
 *          r            V' = V + (parts - 1) E + (parts - 1)(parts - 2) / 2 F
 *         / \           E' = parts E + 3 parts (parts - 1) / 2 F
 *        *---*          F' = parts^2 F
 *       / \ / \
 *      *---+---*        * vertex on an edge, + inside a triangle
 *     / \ / \ / \
 *    p---*---*---q      old vertices keep their numbers and positions */
int subdivide_flat(struct mesh *mesh, int parts, struct error *err) MUST_CHECK;

/* One step of Loop's scheme (C. Loop, Smooth Subdivision Surfaces Based on Triangles, 1987, with
 * Warren's weights inside): each triangle in 4, V' = V + E, F' = 4 F, all vertices move. The
 * boundary follows the cubic B-spline, as does every edge that has not two triangles; a vertex
 * where more or fewer than two such edges meet stays where it is. */
int subdivide_loop(struct mesh *mesh, struct error *err) MUST_CHECK;

/* Splits a mesh that has triangles flatly into parts^2 F of them, as close to `triangles` (>= 1) as
 * a whole number of parts comes; a mesh that has more already stays as it is. */
int subdivide_to(struct mesh *mesh, int64_t triangles, struct error *err) MUST_CHECK;

#endif
