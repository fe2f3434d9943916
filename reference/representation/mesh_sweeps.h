/* Sweeps over the edges of an indexed mesh, which does not store them: its sides are sorted each
 * time (edges.h). Arguments and results as in representation.h. */
#ifndef REFERENCE_REPRESENTATION_MESH_SWEEPS_H
#define REFERENCE_REPRESENTATION_MESH_SWEEPS_H

#include "reference/mesh/mesh.h"

int64_t mesh_edges(const struct mesh *mesh, int32_t *pairs, struct error *err);
int32_t mesh_boundary_loops(const struct mesh *mesh, int32_t *vertices, int32_t *loop_starts,
                            struct error *err);
int mesh_smooth(struct mesh *mesh, struct error *err);
void mesh_vertex_normals(const struct mesh *mesh, float *normals);

/* Refuses a mesh that has a vertex in no triangle: -1 and *err, naming it and `what` cannot hold
 * it. Returns 0 otherwise; -1 also when memory runs out. */
int mesh_refuse_isolated(const struct mesh *mesh, const char *what, struct error *err) MUST_CHECK;

#endif
