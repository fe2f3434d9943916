/* Edges that know two vertices and two faces: what the extended edge list and the face-edge-vertex
 * lists share. */
#ifndef REFERENCE_REPRESENTATION_TWO_SIDED_EDGES_H
#define REFERENCE_REPRESENTATION_TWO_SIDED_EDGES_H

#include "reference/base/error.h"

#include <stdbool.h>
#include <stdint.h>

struct two_sided_edge {
    int32_t from, to; /* initial and final vertex: vi vf, in fin */
    int32_t left;     /* face that runs from `from` to `to`: C_izq, sin */
    int32_t right;    /* face that runs back, or -1 at a boundary: C_der, dest */
};

struct two_sided_edges {
    struct two_sided_edge *table;
    int32_t count;
    int32_t vertex_count; /* vertices are 0 ... vertex_count - 1 */
    int32_t face_count;
};

/* Adds a side to its edge, which starts with left = right = -1: the face's side from one vertex to
 * another. Returns 0, or -1 and *err when the edge has another side that runs the same way, or two
 * others: it names the edge. */
int two_sided_edge_add(struct two_sided_edge *edge, int32_t from, int32_t to, int32_t face,
                       struct error *err) MUST_CHECK;

/* The vertex at which the face's side along the edge starts, and the face at the other side. */
static inline int32_t side_start(const struct two_sided_edge *edge, int32_t face)
{
    return edge->left == face ? edge->from : edge->to;
}

static inline int32_t face_across(const struct two_sided_edge *edge, int32_t face)
{
    return edge->left == face ? edge->right : edge->left;
}

/* Checks that every edge joins two different vertices of the mesh, which no other joins, has a left
 * face, and at most two different faces of the mesh. Returns 0, or -1 and *err naming the edge. */
int two_sided_edges_check(const struct two_sided_edges *edges, struct error *err) MUST_CHECK;

/* Operations; arguments and results as in representation.h. The queries look at every edge. */
int64_t two_sided_pairs(const struct two_sided_edges *edges, int32_t *pairs);
int32_t two_sided_boundary(const struct two_sided_edges *edges, int32_t *vertices,
                           int32_t *loop_starts, struct error *err);
int two_sided_smooth(const struct two_sided_edges *edges, float *positions, struct error *err);
int32_t two_sided_faces_around(const struct two_sided_edges *edges, int32_t vertex, int32_t *faces,
                               int32_t capacity);
int32_t two_sided_vertices_around(const struct two_sided_edges *edges, int32_t vertex,
                                  int32_t *vertices, int32_t capacity);
bool two_sided_is_edge(const struct two_sided_edges *edges, int32_t u, int32_t v);

#endif
