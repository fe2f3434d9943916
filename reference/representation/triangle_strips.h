/* Triangle strips (tiras de triángulos) of positions: each strip is a row of vertices of which
 * every three successive ones are a triangle. self is struct strips (strips.h).
 *
 *       1-----3-----5        strip 0: 0 1 2 3 4 5, triangles
 *      / \   / \   /             (0,1,2)  (2,1,3)  (2,3,4)  (4,3,5)
 *     /   \ /   \ /          the odd ones turned, so that all are wound alike
 *    0-----2-----4
 *
 * Numbers: a vertex is named by any of its entries in the table of positions; entries are the same
 * vertex when their coordinates are equal. to_mesh welds, as for isolated triangles: numbering may
 * change. Faces are numbered strip after strip, which is not the order of the mesh it was built
 * from.
 *
 * Invariants: strips follow each other without gap and have at least 3 entries each; coordinates
 * are finite. It holds all but isolated vertices.
 *
 * Links: none; a strip knows that successive triangles touch, but queries here do not rely on it.
 *
 *     query                   accesses   how
 *     vertices of a face      lg s       the strip is searched for by halving, s strips
 *     all others              n          coordinates are compared through all strips
 *
 * A strip of t triangles has t + 2 entries: long strips come near to one vertex a triangle, so each
 * vertex is stored and transformed about twice (problem 4.3). Cut greedily (strips_from_mesh).
 *
 * Bytes: 4 + 4 a strip (where it starts) + 12 an entry. The course counts a pointer of 8 bytes a
 * strip instead: strips_bytes. */
#ifndef REFERENCE_REPRESENTATION_TRIANGLE_STRIPS_H
#define REFERENCE_REPRESENTATION_TRIANGLE_STRIPS_H

#include "reference/mesh/strips.h"
#include "reference/representation/representation.h"

extern const struct representation representation_triangle_strips;

#endif
