/* Operations through face_vertices alone, for structures without links: faces are read in blocks,
 * from the first to the last. Arguments and results as in representation.h.
 *
 * positions  of the structure's vertices; in the searches: NULL where a vertex has one number, so
 * that numbers are compared, otherwise positions are */
#ifndef REFERENCE_REPRESENTATION_BY_FACES_H
#define REFERENCE_REPRESENTATION_BY_FACES_H

#include "reference/representation/representation.h"

/* -- sweeps --------------------------------------------------------------------------------- */

double faces_area(const struct representation *kind, const void *self, const float *positions);
void faces_normals(const struct representation *kind, const void *self, const float *positions,
                   float *normals);
void faces_vertex_normals(const struct representation *kind, const void *self,
                          const float *positions, float *normals);

/* The indexed mesh with these positions, of kind->vertex_count vertices. Returns 0, or -1, *err. */
int faces_to_mesh(const struct representation *kind, const void *self, const float *positions,
                  struct mesh *mesh, struct error *err) MUST_CHECK;

/* -- searches: all faces are looked at ------------------------------------------------------ */

int32_t faces_search_face_neighbours(const struct representation *kind, const void *self,
                                     const float *positions, int32_t face, int32_t neighbours[3]);
int32_t faces_search_faces_around(const struct representation *kind, const void *self,
                                  const float *positions, int32_t vertex, int32_t *faces,
                                  int32_t capacity);
bool faces_search_edge(const struct representation *kind, const void *self, const float *positions,
                       int32_t u, int32_t v);

/* By numbers only; marks a bit a vertex meanwhile. */
int32_t faces_search_vertices_around(const struct representation *kind, const void *self,
                                     int32_t vertex, int32_t *vertices, int32_t capacity);

#endif
