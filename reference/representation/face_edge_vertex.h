/* Face-edge-vertex lists (estructura caras-aristas-vértices) of polygons of any size: a solid is a
 * list of faces, a face a list of edges, an edge two vertices and the two faces that it parts.
 *
 *          3---2---2---6---4        faces            edges    vi vf  C_izq C_der
 *          |       |       |        0  0 1 2 3       0        0  1   0     -
 *          3   0   1   1   5        1  4 5 6 1       1        1  2   0     1
 *          |       |       |                         2        2  3   0     -
 *          0---0---1---4---5                         3        3  0   0     -
 *                                                    4        1  5   1     -
 *     (document 001's example, its first two faces)  5        5  4   1     -
 *                                                    6        4  2   1     -
 *
 * Document 001 first stores edges as pairs of vertices only, then adds the faces at their left
 * (izquierda: it runs the edge from vi to vf) and right (derecha), -1 where there is none; the
 * second form is the one here, the first is the edge list (edge_list.h). It ends a face's list with
 * NULL; here all lists stand in one table and `starts` says where each begins, one int a face as
 * well. Edges are numbered, and run, as the faces first name them.
 *
 * Invariants: a face has at least three edges, each starts where the one before ends, and the face
 * stands at the side of them that runs this way; no vertex comes twice in a face. It holds
 * boundaries, isolated vertices, and vertices where several fans meet; no edge with more than two
 * faces or with two that run the same way.
 *
 * Links: face to edge, edge to vertex, edge to face; k is the sides of the face.
 *
 *     query                   accesses   how
 *     vertices of a face      k          F-E then E-V
 *     neighbours of a face    k          the other side of each edge
 *     faces around a vertex   n          search through the edges
 *     vertices around one     n          search through the edges
 *     is {u,v} an edge        n          search through the edges
 *
 * The functions of representation_face_edge_vertex are for lists of triangles, as `build` makes
 * them; with larger faces to_mesh fails, and face_vertices and face_neighbours must not be asked.
 *
 * Bytes: 12 a vertex + 16 an edge + 4 a face and one more + 4 a side; with triangles 46 a triangle
 * in a large closed mesh, where E = 3 V and F = 2 V. */
#ifndef REFERENCE_REPRESENTATION_FACE_EDGE_VERTEX_H
#define REFERENCE_REPRESENTATION_FACE_EDGE_VERTEX_H

#include "reference/representation/representation.h"
#include "reference/representation/two_sided_edges.h"

struct face_edge_vertex {
    float *positions;             /* 3 a vertex */
    struct two_sided_edges edges; /* with the counts of vertices and faces */
    int32_t *starts;              /* face f has face_edges[starts[f]] ... [starts[f + 1] - 1] */
    int32_t *face_edges;          /* side_count edges of all faces, counter-clockwise */
    int32_t side_count;
};

/* Polygons: face f has corners[starts[f]] ... corners[starts[f + 1] - 1]; starts has face_count + 1
 * entries, the first 0. All is borrowed. */
struct listed_polygons {
    const float *positions;
    const int32_t *starts, *corners;
    int32_t vertex_count, face_count;
};

/* Makes the lists; the caller owns them (representation_face_edge_vertex.release). Linear.
 * Returns 0, or -1 and *err naming the face or edge that cannot be held. */
int face_edge_vertex_from_polygons(struct face_edge_vertex *list,
                                   const struct listed_polygons *polygons,
                                   struct error *err) MUST_CHECK;

/* Number of sides of a face, and its corners in order: room for as many numbers. */
int32_t face_edge_vertex_sides(const struct face_edge_vertex *list, int32_t face);
void face_edge_vertex_corners(const struct face_edge_vertex *list, int32_t face, int32_t *corners);

extern const struct representation representation_face_edge_vertex;

#endif
