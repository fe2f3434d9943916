/* Numbering edges, for the structures that store them. */
#ifndef REFERENCE_REPRESENTATION_EDGE_NUMBERS_H
#define REFERENCE_REPRESENTATION_EDGE_NUMBERS_H

#include "reference/mesh/mesh.h"

/* Finds which sides lie on the same edge, and numbers edges by their first side: 0, 1, 2 ... as
 * document 001 does it while it reads the faces.
 *
 * starts, ends   vertices that each side joins, two different ones; side_count each
 * edge_of_side   room for side_count
 * returns        number of edges, or -1 and *err (out of memory)
 * cost           linear in sides and vertices, by two counting sorts; 8 bytes a side and 4 a vertex
 *                meanwhile */
int64_t edge_numbers_make(const int32_t *starts, const int32_t *ends, int64_t side_count,
                          int32_t vertex_count, int32_t *edge_of_side, struct error *err);

/* The same for the sides of a valid mesh, numbered 3 * triangle + corner. Refuses degenerate
 * triangles: -1 and *err naming the triangle. Allocates the table, which the caller frees; *err and
 * NULL otherwise. */
int64_t edge_numbers_of_mesh(const struct mesh *mesh, int32_t **edge_of_side, struct error *err);

/* Checks that no two of the edges join the same vertices; pairs[stride * e] and the number after it
 * are the vertices of edge e, all in [0, vertex_count) and different. Linear. Returns 0, or -1 and
 * *err naming the edges. */
int edge_numbers_check(const int32_t *pairs, int64_t stride, int64_t edge_count,
                       int32_t vertex_count, struct error *err) MUST_CHECK;

#endif
