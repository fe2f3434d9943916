/* The sphere of problem 4.1 as a mesh, as a judge sees it: k meridians of k vertices each, from
 * pole to pole, the last joined to the first by indices, and two triangles in each of the k * (k -
 * 1) cells.
 *
 * Vertices are told apart by where they lie, so a student may number vertices and list triangles in
 * any order and cut cells by either diagonal. At a pole k vertices share a place; which meridian
 * each of them belongs to follows from the triangles, and only that they close up around the pole
 * is asked. So there is not one right mesh, as surface.h needs to compare. */
#ifndef GRADERS_LIBRARY_SPHERE_H
#define GRADERS_LIBRARY_SPHERE_H

#include "graders/library/built.h"

/* Judge what was built, with all k * k vertices, k >= 3, and, for triangles, their table. A
 * rejection names the first element at fault, marks all and shows the mesh; nothing is accepted
 * here. Return 0, or -1 and *err (out of memory).
 *
 * Vertices: each place has its vertex, within 0.00001, and each pole has k. */
int sphere_judge_vertices(int32_t k, const struct built_mesh *mesh, struct judgement *out,
                          struct error *err) MUST_CHECK;

/* Triangles: they cover the sphere once, from outside counter-clockwise. Vertices are taken for the
 * place next to them, however far. */
int sphere_judge_triangles(int32_t k, const struct built_mesh *mesh, struct judgement *out,
                           struct error *err) MUST_CHECK;

/* The mesh as it should be, vertex i of meridian j as number j * k + i. The caller owns it. Returns
 * 0, or -1 and *err (out of memory). */
int sphere_make(struct mesh *mesh, int32_t k, struct error *err) MUST_CHECK;

#endif
