/* Problem 4.5 (a): the edge table of any indexed triangle mesh. */
#ifndef EDGE_TABLE_ANY_H
#define EDGE_TABLE_ANY_H

#include <stdint.h>

/* What a function of these exercises returns when malloc, calloc or realloc gave NULL. */
enum { OUT_OF_MEMORY = -1 };

/* Makes the table of edges of a triangle mesh. An edge is an unordered pair of two different
 * vertices that some triangle joins; the table holds every edge once, edges in any order, the two
 * vertices of an edge in any order.
 *
 * The mesh can be anything: triangles in incoherent orientation, open, in several components,
 * empty; with vertices that no triangle uses, edges of more than two triangles, triangles listed
 * twice, and degenerate triangles, that is, with a repeated vertex: (a,a,b) gives the edge {a,b}
 * and (a,a,a) gives none.
 *
 * triangles        triangle_count triples of vertex numbers: triangle t joins triangles[3*t],
 *                  triangles[3*t+1] and triangles[3*t+2], each from 0 to vertex_count - 1. Cannot
 *                  be written. Must not be followed when triangle_count is 0.
 * triangle_count   number of triangles, 0 or more
 * vertex_count     number of vertices, 0 or more. No vertex has more than a constant number of
 *                  neighbours, which does not depend on vertex_count; you are not told it.
 * edges            where to store the table: an array made with malloc (or calloc, realloc) in
 *                  which edge e joins (*edges)[2*e] and (*edges)[2*e+1]. The caller frees it with
 *                  free(). It may be longer than needed, and NULL when there is no edge.
 *
 * returns          the number of edges; or OUT_OF_MEMORY, and then nothing that the function made
 *                  is left and *edges is not looked at
 * cost             time and memory proportional to the size of the mesh, but for a logarithm at
 *                  most */
int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges);

#endif
