/* Indexed mesh with the faces of each vertex (vértice-cara links, in compressed rows): the plain
 * structure that answers local queries without half edges.
 *
 *          3-------2      triangles      starts     vertex_faces
 *          |     / |      0   0 1 2      0  0       0  0  \ of vertex 0
 *          | 1 /   |      1   0 2 3      1  2       1  1  /
 *          | /   0 |                     2  3       2  0    of vertex 1
 *          0-------1                     3  5       3  0  \ of vertex 2
 *                                        4  6       4  1  /
 *                                                   5  1    of vertex 3
 *
 * Invariants: those of the indexed mesh; faces of a vertex ascend; each corner of each face is
 * listed once, so a degenerate face stands twice or three times in its vertex's row. It holds
 * everything. An edit of one triangle moves half of the table: this structure is built anew
 * instead.
 *
 * Links: face to vertex, vertex to face. Not in the course; k is the valence. A question about the
 * edge {u,v} looks through the shorter of the two rows.
 *
 *     query                   accesses   how
 *     vertices of a face      1          its row
 *     neighbours of a face    k          per side, the shorter of its ends' rows
 *     faces around a vertex   k          its row
 *     vertices around one     k^2        corners of its faces, each kept if no earlier face of the
 *                                        shorter row has it
 *     is {u,v} an edge        k          the shorter row
 *
 * Bytes: 16 a vertex + 24 a triangle + 4; 32 a triangle in a large closed mesh, where F = 2 V. */
#ifndef REFERENCE_REPRESENTATION_INDEXED_CSR_H
#define REFERENCE_REPRESENTATION_INDEXED_CSR_H

#include "reference/representation/representation.h"

struct indexed_csr {
    struct mesh mesh;
    int32_t *starts;       /* vertex v has vertex_faces[starts[v]] ... [starts[v + 1] - 1] */
    int32_t *vertex_faces; /* 3 * triangle_count */
};

extern const struct representation representation_indexed_csr;

#endif
