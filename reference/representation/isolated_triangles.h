/* Isolated triangles (triángulos aislados, triangle soup): nine floats a triangle, nothing shared
 * and nothing said about what touches what. self is struct soup (soup.h).
 *
 *          5-----4   2       corners
 *          |   /   / |       0  x y z  \
 *          | /   /   |       1  x y z   > triangle 0
 *          3   0-----1       2  x y z  /
 *                            3  x y z  \  corner 3 lies where corner 0 lies
 *                            4  x y z   > triangle 1
 *                            5  x y z  /  corner 4 lies where corner 2 lies
 *
 * Numbers: a vertex is named by any of its corners, 0 ... 3 F - 1; corners are the same vertex when
 * their coordinates are equal. to_mesh welds them by hashing; vertices of the mesh that had equal
 * coordinates become one, so numbering may change, and topology may.
 *
 * Invariants: every coordinate is finite. It holds all but isolated vertices, which have no
 * triangle to be stored with.
 *
 * Links: none. Document 000: topology can only be found by comparing coordinates, and not robustly.
 *
 *     query                   accesses   how
 *     vertices of a face      1          its row
 *     all others              n          coordinates are compared through the whole table
 *
 * A vertex with k triangles is stored, and transformed, k times: about 6 times in a closed mesh.
 * Vertex normals, edges, boundary loops and smoothing weld first.
 *
 * Bytes: 36 a triangle; 72 a vertex in a large closed mesh, where F = 2 V. */
#ifndef REFERENCE_REPRESENTATION_ISOLATED_TRIANGLES_H
#define REFERENCE_REPRESENTATION_ISOLATED_TRIANGLES_H

#include "reference/mesh/soup.h"
#include "reference/representation/representation.h"

extern const struct representation representation_isolated_triangles;

#endif
