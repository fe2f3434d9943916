/* Indexed mesh (malla indexada, lista dei vertici): a table of vertices and a table of triangles
 * that name their vertices. The structure of files and of graphics cards; self is struct mesh
 * (mesh.h).
 *
 *          3-------2      vertices         triangles
 *          |     / |      0  x y z         0   0 1 2
 *          | 1 /   |      1  x y z         1   0 2 3
 *          | /   0 |      2  x y z
 *          0-------1      3  x y z
 *
 * Invariants: every index is in [0, vertex_count); coordinates are finite. It holds everything:
 * boundaries, non-manifold edges, any orientation, isolated vertices.
 *
 * Links: triangle to vertex, and none else. Document 000: whether a vertex is in a given triangle
 * takes constant time; whether two vertices share an edge, and all else about adjacency, a search
 * through the triangles, O(n_t).
 *
 *     query                   accesses   how
 *     vertices of a face      1          its row
 *     neighbours of a face    n          search for a row with two of its vertices
 *     faces around a vertex   n          search
 *     vertices around one     n          search
 *     is {u,v} an edge        n          search
 *
 * Sweeps over edges sort all sides each time, in linear time: nothing about edges is kept.
 *
 * Bytes: 12 a vertex + 12 a triangle; 18 a triangle in a large closed mesh, where F = 2 V. */
#ifndef REFERENCE_REPRESENTATION_INDEXED_MESH_H
#define REFERENCE_REPRESENTATION_INDEXED_MESH_H

#include "reference/representation/representation.h"

extern const struct representation representation_indexed_mesh;

#endif
