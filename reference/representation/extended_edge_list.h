/* Extended edge list (lista degli spigoli estesa): the edge list, whose edges also know the face at
 * either side.
 *
 *          3--l3---2       edges (in, fin; sin, dest)      faces
 *          |  1  / |       l0  0 1;  0  -                  0  l0 l1 l2
 *         l4  l2   l1      l1  1 2;  0  -                  1  l2 l3 l4
 *          | /  0  |       l2  2 0;  0  1
 *          0--l0---1       l3  2 3;  1  -
 *                          l4  3 0;  1  -
 *
 * The left face (sin, sinistra) runs along the edge from its initial to its final vertex, the right
 * one (dest, destra) back; -1 where there is none. Edges are numbered by first appearance and run
 * as the first face that has them, so only the right face can lack.
 *
 * Invariants: those of the edge list; edge i of face f has f at one side, and starts where edge i -
 * 1 of f ends. It holds boundaries and isolated vertices, and vertices where several fans meet; no
 * edge with more than two faces or with two that run the same way, no degenerate triangle.
 *
 * Links: face to edge, edge to vertex, edge to face. Document 004: incidence between edges and
 * faces is much simpler to find.
 *
 *     query                   accesses   how
 *     vertices of a face      1          through its edges: the side tells which end comes first
 *     neighbours of a face    1          the other side of each edge
 *     faces at an edge        1          its row
 *     faces around a vertex   n          search through the edges
 *     vertices around one     n          search through the edges
 *     is {u,v} an edge        n          search through the edges
 *
 * Bytes: 12 a vertex + 16 an edge + 12 a triangle; 42 a triangle in a large closed mesh, where
 * E = 3 V and F = 2 V. */
#ifndef REFERENCE_REPRESENTATION_EXTENDED_EDGE_LIST_H
#define REFERENCE_REPRESENTATION_EXTENDED_EDGE_LIST_H

#include "reference/representation/representation.h"
#include "reference/representation/two_sided_edges.h"

struct extended_edge_list {
    float *positions;             /* 3 a vertex */
    struct two_sided_edges edges; /* with the counts of vertices and faces */
    int32_t *face_edges;          /* 3 a face */
};

extern const struct representation representation_extended_edge_list;

#endif
