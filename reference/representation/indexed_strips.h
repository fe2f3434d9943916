/* Indexed triangle strips (tiras de triángulos indexadas): a table of vertices, each stored once,
 * and strips of vertex numbers.
 *
 *       1-----3-----5        vertices      strip 0: 0 1 2 3 4 5, triangles
 *      / \   / \   /         0  x y z               (0,1,2)  (2,1,3)  (2,3,4)  (4,3,5)
 *     /   \ /   \ /          ...
 *    0-----2-----4           5  x y z
 *
 * Coordinates are not repeated, and numbers less than in the indexed mesh: about one a triangle in
 * long strips instead of three, so each vertex is named about twice, not six times. Numbers of
 * vertices stay those of the mesh; faces are numbered strip after strip.
 *
 * Invariants: strips follow each other without gap and have at least 3 entries each; every index is
 * in [0, vertex_count); coordinates are finite. It holds everything that the indexed mesh holds.
 *
 * Links: face to vertex, through the strip.
 *
 *     query                   accesses   how
 *     vertices of a face      lg s       the strip is searched for by halving, s strips
 *     all others              n          search through all strips
 *
 * Sweeps over edges make the indexed mesh first. Cut greedily (strip_numbers_from_mesh).
 *
 * Bytes: 12 a vertex + 4 and 4 a strip (where it starts) + 4 an entry; toward 10 a triangle in a
 * large closed mesh of long strips. */
#ifndef REFERENCE_REPRESENTATION_INDEXED_STRIPS_H
#define REFERENCE_REPRESENTATION_INDEXED_STRIPS_H

#include "reference/representation/representation.h"

struct indexed_strips {
    float *positions; /* 3 * vertex_count */
    int32_t *starts;  /* strip s has indices[starts[s]] ... indices[starts[s + 1] - 1] */
    int32_t *indices; /* index_count vertices */
    int32_t vertex_count;
    int32_t strip_count;
    int32_t index_count;
};

extern const struct representation representation_indexed_strips;

#endif
