/* Winged edges (Baumgart 1975): the edge is the central element and knows the two faces beside it
 * and, on each of them, the edge before and after it. Course documents 000, 001, 002 and 004.
 *
 *                   |                        here          001    000, 002
 *    next[0]     vertex[1]    previous[1]    vertex[0]     Vi     vi    initial vertex
 *         \_________ | _________/            vertex[1]     Vf     vf    final vertex
 *                    |                       face[0]       Cd     ti    face that runs it forwards
 *                    |                       face[1]       Ci     td    face that runs it backwards
 *       face[0]      | edge    face[1]       previous[0]   Ada    aai   edge before it in face[0]
 *       (left)       |         (right)       next[0]       Ads    asi   edge after it in face[0]
 *          _________ | _________             previous[1]   Aia    aad   edge before it in face[1]
 *         /      vertex[0]      \            next[1]       Ais    asd   edge after it in face[1]
 *    previous[0]     |        next[1]        vertex_edge          taver one edge of each vertex
 *                                            face_edge     Arista tatri one edge of each face
 *
 * So each edge has two sides, way 0 (forwards, from vertex[0] to vertex[1], with face[0] to its
 * left) and way 1 (backwards). A link names an edge but not the way in which it is run; each step
 * has to compare vertices to find out, which is what the half edge saves.
 *
 * Faces may have any number of corners. On a boundary the missing face is -1, and the links on that
 * side lead along the hole, with the hole to their left, as if it were a face.
 *
 * Invariants (winged_edge_check), for each side, from its vertex v to its vertex w:
 *  - v is not w, and at most one of the two faces is -1;
 *  - the next edge leaves w with the same face, and its previous edge is this one;
 *  - the sides of a face are one cycle of next, of at least 3; face_edge is one of them;
 *  - the sides that leave a vertex are one cycle of turning around it: one fan (manifold);
 *  - vertex_edge is an edge at the vertex (-1: isolated); on a boundary it is the one that has no
 *    face to its right when seen from the vertex, so that turning counter-clockwise from it meets
 *    every face.
 *
 * It refuses degenerate faces, edges with more than two faces, edges that two faces run through in
 * the same direction, and vertices whose faces are not one fan. It holds isolated vertices.
 *
 * Bytes: 32 an edge, 4 a face, 16 a vertex (12 of them its position); a large closed triangle mesh
 * takes 60 a triangle. Accesses, for k corners of a face or k faces of a vertex: ends, faces and
 * neighbours of an edge 1; corners or neighbours of a face, faces or vertices around a vertex, is
 * it an edge: k. Document 001's own queries are in winged_edge_queries.h, edits in
 * winged_edge_edit.h. */
#ifndef REFERENCE_REPRESENTATION_WINGED_EDGE_H
#define REFERENCE_REPRESENTATION_WINGED_EDGE_H

#include "reference/mesh/mesh.h"
#include "reference/representation/sides.h"

#include <stdbool.h>
#include <stdint.h>

/* One row of the course's table; index 0 is forwards (left), 1 backwards (right). */
struct winged_edge {
    int32_t vertex[2];
    int32_t face[2]; /* -1: none, a boundary edge */
    int32_t previous[2];
    int32_t next[2];
};

/* An element that an edit removed has WINGED_EDGE_REMOVED as vertex[0], edge of its vertex or edge
 * of its face, until winged_edge_compact (winged_edge_edit.h). A built mesh has none. */
enum { WINGED_EDGE_REMOVED = -2 };

struct winged_edge_mesh {
    float *positions;     /* 3 a vertex */
    int32_t *vertex_edge; /* taver; -1: isolated */
    int32_t *face_edge;   /* tatri: the edge of the face's first side */
    struct winged_edge *edges;
    int32_t vertex_count, face_count, edge_count;          /* removed elements included */
    int32_t vertex_capacity, face_capacity, edge_capacity; /* room in the tables */
};

/* Called for every row that a step reads from the edge, vertex or face table. Does nothing, but
 * where a source that counts accesses (bench/compare/counted_winged_edge.c) has defined it before.
 */
#ifndef WINGED_EDGE_ACCESS
#define WINGED_EDGE_ACCESS(row) ((void)(row))
#endif

/* One way of running an edge. */
struct winged_side {
    int32_t edge;
    int32_t way; /* 0 forwards, 1 backwards */
};

/* Builds from faces, as document 001 does: edges are numbered as reading the faces in order meets
 * them, and run forwards in the face that names them first.
 *
 * we         its old contents are not looked at; on success the caller owns it
 * positions  3 a vertex, copied
 * returns    0, or -1 and *err naming what it refuses (above), or out of memory; then *we is empty
 * cost       linear */
int winged_edge_build(struct winged_edge_mesh *we, const struct polygons *polygons,
                      const float *positions, struct error *err) MUST_CHECK;

/* Frees the tables and leaves the empty mesh; a zeroed one may be released. */
void winged_edge_release(struct winged_edge_mesh *we);

/* Checks the invariants. Returns 0, or -1 and *err naming the element at fault. Linear. */
int winged_edge_check(const struct winged_edge_mesh *we, struct error *err) MUST_CHECK;

/* The indexed mesh: vertices and faces in order, each face from its first corner. The caller owns
 * it. Returns 0, or -1 and *err: a face that is no triangle, removed elements, out of memory. */
int winged_edge_to_mesh(const struct winged_edge_mesh *we, struct mesh *mesh,
                        struct error *err) MUST_CHECK;

/* -- steps ----------------------------------------------------------------------------------- */

static inline const struct winged_edge *winged_edge_row(const struct winged_edge_mesh *we,
                                                        int32_t edge)
{
    WINGED_EDGE_ACCESS(we->edges + edge);
    return we->edges + edge;
}

static inline int32_t winged_edge_start(const struct winged_edge_mesh *we, struct winged_side side)
{
    return winged_edge_row(we, side.edge)->vertex[side.way];
}

static inline int32_t winged_edge_end(const struct winged_edge_mesh *we, struct winged_side side)
{
    return winged_edge_row(we, side.edge)->vertex[1 - side.way];
}

static inline int32_t winged_edge_face(const struct winged_edge_mesh *we, struct winged_side side)
{
    return winged_edge_row(we, side.edge)->face[side.way];
}

static inline struct winged_side winged_edge_twin(struct winged_side side)
{
    return (struct winged_side){side.edge, 1 - side.way};
}

/* The side of an edge that leaves one of its two vertices. */
static inline struct winged_side winged_edge_leaving(const struct winged_edge_mesh *we,
                                                     int32_t edge, int32_t vertex)
{
    return (struct winged_side){edge, winged_edge_row(we, edge)->vertex[0] != vertex};
}

/* The side after this one in its face or along its hole. */
static inline struct winged_side winged_edge_next(const struct winged_edge_mesh *we,
                                                  struct winged_side side)
{
    const struct winged_edge *edge = winged_edge_row(we, side.edge);
    return winged_edge_leaving(we, edge->next[side.way], edge->vertex[1 - side.way]);
}

/* The sides that leave the same vertex after this one, counter-clockwise and clockwise. */
static inline struct winged_side winged_edge_turn_left(const struct winged_edge_mesh *we,
                                                       struct winged_side side)
{
    const struct winged_edge *edge = winged_edge_row(we, side.edge);
    return winged_edge_leaving(we, edge->previous[side.way], edge->vertex[side.way]);
}

static inline struct winged_side winged_edge_turn_right(const struct winged_edge_mesh *we,
                                                        struct winged_side side)
{
    const struct winged_edge *edge = winged_edge_row(we, side.edge);
    return winged_edge_leaving(we, edge->next[1 - side.way], edge->vertex[side.way]);
}

/* The first side of a face in use, and the side where the fan of a vertex starts (the vertex must
 * not be isolated). */
static inline struct winged_side winged_edge_of_face(const struct winged_edge_mesh *we,
                                                     int32_t face)
{
    WINGED_EDGE_ACCESS(we->face_edge + face);
    int32_t edge = we->face_edge[face];
    return (struct winged_side){edge, winged_edge_row(we, edge)->face[0] != face};
}

static inline struct winged_side winged_edge_of_vertex(const struct winged_edge_mesh *we,
                                                       int32_t vertex)
{
    WINGED_EDGE_ACCESS(we->vertex_edge + vertex);
    return winged_edge_leaving(we, we->vertex_edge[vertex], vertex);
}

/* Whether a vertex is an end of a boundary edge. */
static inline bool winged_edge_on_boundary(const struct winged_edge_mesh *we, int32_t vertex)
{
    return we->vertex_edge[vertex] >= 0 &&
           winged_edge_face(we, winged_edge_twin(winged_edge_of_vertex(we, vertex))) < 0;
}

/* The edge between u and v, or -1. Cost: the valence of u. */
int32_t winged_edge_find(const struct winged_edge_mesh *we, int32_t u, int32_t v);

#endif
