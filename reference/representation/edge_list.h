/* Edge list (lista degli spigoli): vertices; edges of two vertices; triangles of three edges.
 * Neither a vertex nor an edge is stored twice.
 *
 *          3--l3---2       edges (in, fin)      faces
 *          |  1  / |       l0  0 1              0  l0 l1 l2
 *         l4  l2   l1      l1  1 2              1  l2 l3 l4
 *          | /  0  |       l2  2 0
 *          0--l0---1       l3  2 3
 *                          l4  3 0
 *
 * Edge i of a face joins its corners i and i + 1; which end comes first is not said, it follows
 * from the edge before: corner i is the vertex that edges i - 1 and i share. Edges are numbered by
 * first appearance and run (in to fin, initial to final vertex) as the first face that has them.
 *
 * Invariants: an edge joins two different vertices, and no other edge joins the same two; the three
 * edges of a face join three vertices in a ring; every edge is in a face. It holds boundaries,
 * edges with many faces and any orientation, and isolated vertices; not degenerate triangles, of
 * which one edge would join a vertex to itself.
 *
 * Links: face to edge, edge to vertex. Document 004: searches for incidence are simpler, but not
 * all of them.
 *
 *     query                   accesses   how
 *     vertices of a face      1          through its edges
 *     edges of a face         1          its row
 *     vertices of an edge     1          its row
 *     neighbours of a face    n          search for a face with one of its edges
 *     faces around a vertex   n          search through the faces
 *     vertices around one     n          search through the edges
 *     is {u,v} an edge        n          search through the edges
 *
 * Bytes: 12 a vertex + 8 an edge + 12 a triangle; 30 a triangle in a large closed mesh, where
 * E = 3 V and F = 2 V. */
#ifndef REFERENCE_REPRESENTATION_EDGE_LIST_H
#define REFERENCE_REPRESENTATION_EDGE_LIST_H

#include "reference/representation/representation.h"

struct triangle_edge_list {
    float *positions; /* 3 * vertex_count */
    int32_t *ends;    /* 2 * edge_count: initial and final vertex of each edge */
    int32_t *edges;   /* 3 * face_count: edges of each face */
    int32_t vertex_count;
    int32_t edge_count;
    int32_t face_count;
};

extern const struct representation representation_edge_list;

#endif
