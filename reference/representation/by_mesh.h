/* Operations by way of an indexed mesh made for the purpose, for structures that do not store edges
 * and for those that do not even share vertices (there, making the mesh welds). Arguments and
 * results as in representation.h; linear in all, and heavy. */
#ifndef REFERENCE_REPRESENTATION_BY_MESH_H
#define REFERENCE_REPRESENTATION_BY_MESH_H

#include "reference/representation/representation.h"

/* vertex_names of a structure that does not share vertices: the lowest corner of each. */
int lowest_corners(const struct representation *kind, const void *self, const struct mesh *mesh,
                   int32_t *names, struct error *err) MUST_CHECK;

int64_t by_mesh_edges(const struct representation *kind, const void *self, int32_t *pairs,
                      struct error *err);
int32_t by_mesh_boundary_loops(const struct representation *kind, const void *self,
                               int32_t *vertices, int32_t *loop_starts, struct error *err);
int by_mesh_vertex_normals(const struct representation *kind, const void *self, float *normals,
                           struct error *err);

/* positions  of self, which the step moves */
int by_mesh_smooth(const struct representation *kind, const void *self, float *positions,
                   struct error *err);

/* positions  of self; for structures that do not share vertices */
int32_t by_mesh_vertices_around(const struct representation *kind, const void *self,
                                const float *positions, int32_t vertex, int32_t *vertices,
                                int32_t capacity);

#endif
