/* Problem 4.5 (b): the edge table of a closed, coherently oriented indexed triangle mesh. */
#ifndef EDGE_TABLE_CLOSED_H
#define EDGE_TABLE_CLOSED_H

#include <stdint.h>

/* What a function of these exercises returns when malloc, calloc or realloc gave NULL. */
enum { OUT_OF_MEMORY = -1 };

/* Makes the table of edges of a triangle mesh. An edge is an unordered pair of two different
 * vertices that some triangle joins; the table holds every edge once, edges in any order, the two
 * vertices of an edge in any order.
 *
 * The mesh is closed and its orientation is coherent: every edge belongs to exactly two
 * triangles, and where one of them goes from i to j, the other goes from j to i (a triangle
 * (a,b,c) goes from a to b, from b to c and from c to a). No triangle repeats a vertex. The mesh
 * can have handles (any genus), several components, vertices that no triangle uses, and it can be
 * empty.
 *
 * triangles        triangle_count triples of vertex numbers: triangle t joins triangles[3*t],
 *                  triangles[3*t+1] and triangles[3*t+2], each from 0 to vertex_count - 1. Cannot
 *                  be written. Must not be followed when triangle_count is 0.
 * triangle_count   number of triangles, 0 or more, always even
 * vertex_count     number of vertices, 0 or more
 * edges            where to store the table: an array made with malloc (or calloc, realloc) in
 *                  which edge e joins (*edges)[2*e] and (*edges)[2*e+1]. The caller frees it with
 *                  free(). It may be longer than needed, and NULL when there is no edge.
 *
 * returns          the number of edges; or OUT_OF_MEMORY, and then nothing that the function made
 *                  is left and *edges is not looked at
 * cost             time and memory proportional to triangle_count. What is promised about the
 *                  mesh makes every search unnecessary, and the work is bounded accordingly. */
int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges);

#endif
