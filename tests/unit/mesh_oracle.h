/* What a small mesh is, found in the plainest way: a table of vertex pairs. The truth that tests
 * compare queries with. Functions of this file abort when memory runs out. */
#ifndef TESTS_UNIT_MESH_ORACLE_H
#define TESTS_UNIT_MESH_ORACLE_H

#include "reference/mesh/mesh.h"

#include <stdbool.h>
#include <stdint.h>

struct oracle {
    const struct mesh *mesh; /* borrowed */
    uint16_t *sides;         /* [u * vertex_count + v]: sides that run from u to v */
};

/* The caller owns it (oracle_release); 2 bytes a pair of vertices. */
void oracle_init(struct oracle *oracle, const struct mesh *mesh);
void oracle_release(struct oracle *oracle);

/* Sides on the edge {u,v}, either way: 0 when it is none. */
int oracle_uses(const struct oracle *oracle, int32_t u, int32_t v);

/* Whether it has any edge with more than two sides, or with two that run the same way. */
bool oracle_has_crowded_edge(const struct oracle *oracle);
bool oracle_is_coherent(const struct oracle *oracle);

int64_t oracle_edge_count(const struct oracle *oracle, int uses); /* with so many; 0: all edges */

/* In ascending order; room for all faces or vertices. Return how many. */
int32_t oracle_faces_around(const struct oracle *oracle, int32_t vertex, int32_t *faces);
int32_t oracle_vertices_around(const struct oracle *oracle, int32_t vertex, int32_t *vertices);

/* The lowest other face at each side, or -1. */
void oracle_face_neighbours(const struct oracle *oracle, int32_t face, int32_t neighbours[3]);

bool oracle_is_boundary_vertex(const struct oracle *oracle, int32_t vertex);

/* Half the cross product of a face, or the sum over a vertex's faces; *scale: sum of lengths. */
void oracle_area_vector(const struct oracle *oracle, int32_t face, double vector[3]);
void oracle_vertex_vector(const struct oracle *oracle, int32_t vertex, double vector[3],
                          double *scale);

/* Whether both are the same triangles: same places (0 and -0 are equal) and winding, in any order,
 * from any corner, with any numbering. */
bool same_surface(const struct mesh *a, const struct mesh *b);

/* Whether both have the same vertices, bit for bit, and the same triangles by numbers, in any order
 * and from any corner. */
bool same_numbered_mesh(const struct mesh *a, const struct mesh *b);

#endif
