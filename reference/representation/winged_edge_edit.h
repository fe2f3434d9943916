/* Edits of a winged-edge mesh of triangles: what the structure is for, since each touches only the
 * neighbourhood. All invariants (winged_edge_check) hold after each; V - E + F does not change.
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
 * elements stay in the tables, marked, until winged_edge_compact; walks never meet them. */
#ifndef REFERENCE_REPRESENTATION_WINGED_EDGE_EDIT_H
#define REFERENCE_REPRESENTATION_WINGED_EDGE_EDIT_H

#include "reference/representation/winged_edge.h"

/* Makes room for so many more elements, so that edits need not grow the tables. Returns 0, or -1
 * and *err (out of memory, or more edges than an int32 can number). */
int winged_edge_reserve(struct winged_edge_mesh *we, int64_t more_vertices, int64_t more_faces,
                        int64_t more_edges, struct error *err) MUST_CHECK;

/* Puts a new vertex into triangle `face`, which is in use, and joins it to the corners. The face
 * keeps its first side; the new faces, which keep its second and third, are the last two. Constant
 * time. Returns the vertex, or -1 and *err. */
int32_t winged_edge_split_face(struct winged_edge_mesh *we, int32_t face, const float position[3],
                               struct error *err) MUST_CHECK;

/* Puts a new vertex on the edge of side h and joins it to the opposite corners of its one or
 * two triangles. Constant time. Returns the vertex, or -1 and *err. */
int32_t winged_edge_split_edge(struct winged_edge_mesh *we, struct winged_side h,
                               const float position[3], struct error *err) MUST_CHECK;

/* Whether the edge of h has two triangles whose opposite corners are no edge yet. Cost k. */
bool winged_edge_can_flip(const struct winged_edge_mesh *we, struct winged_side h);

/* Turns the edge of h within its two triangles, counter-clockwise; h must be one that can. Constant
 * time. */
void winged_edge_flip(struct winged_edge_mesh *we, struct winged_side h);

/* Whether the edge of h = u -> v may be shrunk to v so that the surface stays the same up to shape:
 * the link condition (Dey, Edelsbrunner, Guha, Nekhayev 1999). The only common neighbours of u and
 * v are the corners opposite their edge; not both are on the boundary unless the edge is; no
 * triangle hangs by this edge alone; it is no tetrahedron. Cost: the product of the valences at
 * worst. */
bool winged_edge_can_collapse(const struct winged_edge_mesh *we, struct winged_side h);

/* Shrinks the edge of h = u -> v to v, which keeps its position; h must be one that can. Removes u,
 * the triangles at the edge, and the edge with one of the others in each. Cost k. */
void winged_edge_collapse(struct winged_edge_mesh *we, struct winged_side h);

/* Drops the removed elements from the tables; those that stay keep their order. Linear. Returns 0,
 * or -1 and *err (out of memory; then nothing is changed). */
int winged_edge_compact(struct winged_edge_mesh *we, struct error *err) MUST_CHECK;

#endif
