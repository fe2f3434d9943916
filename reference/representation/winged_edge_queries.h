/* The queries of course document 001 (navigation graph of winged edges), each with the accesses
 * that the document gives it; bench/compare/claims.h counts them. An access is the reading of one
 * row of one of the three tables. k is the number of corners of the face, n that of the edges that
 * are met.
 *
 *                                   document   here
 *     edges that touch an edge      n          n + 2, the edge itself at each end
 *     edges of a face               k          k + 1, the face's row
 *     edges of a vertex             n          n + 1, the vertex's row
 *     vertices of a face            k^2        k + 1: the rows of the edges hold them
 *     faces that touch a face       k^2        k + 1: likewise
 *     faces of a vertex             n          n + 1
 *
 * All write at most `capacity` numbers and return how many there are. Counter-clockwise; on a
 * boundary from one end to the other. The vertex of a query must not be isolated. */
#ifndef REFERENCE_REPRESENTATION_WINGED_EDGE_QUERIES_H
#define REFERENCE_REPRESENTATION_WINGED_EDGE_QUERIES_H

#include "reference/representation/winged_edge.h"

/* Edges that share a vertex with the edge, those of its initial vertex first. In a triangle mesh
 * the edges of its two triangles come once each, since they touch at one end only. */
int32_t winged_edge_edges_of_edge(const struct winged_edge_mesh *we, int32_t edge, int32_t *edges,
                                  int32_t capacity);

int32_t winged_edge_edges_of_face(const struct winged_edge_mesh *we, int32_t face, int32_t *edges,
                                  int32_t capacity);
int32_t winged_edge_edges_of_vertex(const struct winged_edge_mesh *we, int32_t vertex,
                                    int32_t *edges, int32_t capacity);
int32_t winged_edge_vertices_of_face(const struct winged_edge_mesh *we, int32_t face,
                                     int32_t *vertices, int32_t capacity);

/* Faces that share an edge with the face; one that shares several comes several times. */
int32_t winged_edge_faces_of_face(const struct winged_edge_mesh *we, int32_t face, int32_t *faces,
                                  int32_t capacity);
int32_t winged_edge_faces_of_vertex(const struct winged_edge_mesh *we, int32_t vertex,
                                    int32_t *faces, int32_t capacity);

#endif
