/* Edits of a half-edge mesh of triangles: what the structure is for, since each touches only the
 * neighbourhood. All invariants (half_edge_check) hold after each; V - E + F does not change.
 *
 *  split face f     split edge h          flip h             collapse h: u is removed, v stays
 *
 *       c                 w                 w                    l                  l
 *      /|\               /|\               / \                  / \                 |
 *     / | \             / | \             / | \                /   \                |
 *    /  m  \           u--m--v           u  |  v              u-->--v      --->     v
 *   / /   \ \           \ | /             \ | /                \   /                |
 *  a---------b           \|/               \ /                  \ /                 |
 *                         x                 x                    r                  r
 *
 * Edits that can run out of memory return -1 and *err and then have changed nothing. Removed
 * elements stay in the tables, marked, until half_edge_compact; walks never meet them. */
#ifndef REFERENCE_REPRESENTATION_HALF_EDGE_EDIT_H
#define REFERENCE_REPRESENTATION_HALF_EDGE_EDIT_H

#include "reference/representation/half_edge.h"

/* Makes room for so many more elements, so that edits need not grow the tables. Returns 0, or -1
 * and *err (out of memory, or more half edges than an int32 can number). */
int half_edge_reserve(struct half_edge_mesh *he, int64_t more_vertices, int64_t more_faces,
                      int64_t more_half_edges, struct error *err) MUST_CHECK;

/* Puts a new vertex into triangle `face`, which is in use, and joins it to the corners. The face
 * keeps its first side; the new faces, which keep its second and third, are the last two. Constant
 * time. Returns the vertex, or -1 and *err. */
int32_t half_edge_split_face(struct half_edge_mesh *he, int32_t face, const float position[3],
                             struct error *err) MUST_CHECK;

/* Puts a new vertex on the edge of half edge h and joins it to the opposite corners of its one or
 * two triangles. Constant time but for a boundary edge, where the loop is mended in time k. Returns
 * the vertex, or -1 and *err. */
int32_t half_edge_split_edge(struct half_edge_mesh *he, int32_t h, const float position[3],
                             struct error *err) MUST_CHECK;

/* Whether the edge of h has two triangles whose opposite corners are no edge yet. Cost k. */
bool half_edge_can_flip(const struct half_edge_mesh *he, int32_t h);

/* Turns the edge of h within its two triangles, counter-clockwise; h must be one that can. Constant
 * time. */
void half_edge_flip(struct half_edge_mesh *he, int32_t h);

/* Whether the edge of h = u -> v may be shrunk to v so that the surface stays the same up to shape:
 * the link condition (Dey, Edelsbrunner, Guha, Nekhayev 1999). The only common neighbours of u and
 * v are the corners opposite their edge; not both are on the boundary unless the edge is; no
 * triangle hangs by this edge alone; it is no tetrahedron. Cost: the product of the valences at
 * worst. */
bool half_edge_can_collapse(const struct half_edge_mesh *he, int32_t h);

/* Shrinks the edge of h = u -> v to v, which keeps its position; h must be one that can. Removes u,
 * the triangles at the edge, and the edge with one of the others in each. Cost k. */
void half_edge_collapse(struct half_edge_mesh *he, int32_t h);

/* Drops the removed elements from the tables; those that stay keep their order. Linear. Returns 0,
 * or -1 and *err (out of memory; then nothing is changed). */
int half_edge_compact(struct half_edge_mesh *he, struct error *err) MUST_CHECK;

#endif
