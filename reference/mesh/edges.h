/* The edges of a mesh, each once, with the triangles that use it: what every topology check reads.
 *
 * An edge is an unordered pair of different vertices. What the edges of a degenerate triangle are
 * (two corners the same vertex) has two answers, because there are two questions:
 *
 *     of the surface   here, check.h, representation/, Euler numbers: it covers nothing, so it is
 * no face and has no sides; mesh_degenerate_triangles (check.h) finds it of the table
 * kernels/edges_any.h, the exercise edge-table-any: every pair of different vertices that follow
 * each other in a triangle as it is listed; (a,a,b) has {a,b}, (a,a,a) has none
 *
 * They differ only in edges that no other triangle has: (0,1,2) and (3,4,4) have 3 of the surface
 * and 4 of the table. A triangle that is listed twice adds no edge in either. */
#ifndef REFERENCE_MESH_EDGES_H
#define REFERENCE_MESH_EDGES_H

#include "reference/mesh/mesh.h"

#include <stdbool.h>
#include <stdint.h>

struct edge {
    int32_t low, high;      /* the two vertices, low < high */
    int32_t forward_count;  /* sides of triangles that run from low to high */
    int32_t backward_count; /* sides that run from high to low */
    int64_t first_use;      /* its sides: uses[first_use] and the forward + backward - 1 after it */
};

/* Sides are numbered 3 * triangle + corner: the side from that corner to the next one. */
struct edge_list {
    struct edge *edges; /* by low, then by high */
    int32_t *uses;      /* side numbers, edge after edge, ascending within an edge */
    int64_t edge_count;
};

/* Lists the edges of a valid mesh. The caller owns the list (edge_list_release).
 *
 * returns  0, or -1 and *err (out of memory); then the list is empty
 * cost     linear in vertices and triangles, by counting sort; 36 bytes a triangle meanwhile */
int edge_list_init(struct edge_list *list, const struct mesh *mesh, struct error *err) MUST_CHECK;

/* Frees the tables and leaves the empty list; a zeroed list may be released. */
void edge_list_release(struct edge_list *list);

/* Number of sides on an edge: 1 on a boundary, 2 inside a manifold, more where it is none. */
static inline int64_t edge_use_count(const struct edge *edge)
{
    return (int64_t)edge->forward_count + edge->backward_count;
}

/* Whether two of a triangle's corners are the same vertex. */
static inline bool triangle_is_degenerate(const int32_t corner[3])
{
    return corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0];
}

#endif
