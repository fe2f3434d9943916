/* Half edges: every edge is two half edges that run against each other, one for each face beside
 * it. Course document 004 (half edge) and, with other names, 001 (semiaristas).
 *
 *               v                       here      004         001    what it is
 *             / ^ \                     origin    origine     Vi     vertex where it starts
 *           /  | | \                    twin      gemello     H      the other half of its edge
 *         /    | |   \                  next      successivo  As     the one after it in its face
 *       /  h   | |  t  \                face      faccia      C      the face to its left
 *       \   f  | |  g  /
 *         \    | |   /           h runs from u up to v with face f to its left, t = twin(h) from v
 *           \  | v /             down to u with face g to its left. next(h) leaves v around f. The
 *             \   /              end of h is the origin of its twin. A vertex keeps one half edge
 *               u                that leaves it, a face one of its own.
 *
 * Faces may have any number of corners. Where a face has no neighbour its edge still has two
 * halves: the outer one has face -1, and the half edges without a face are linked by next into
 * loops, one around each hole, with the hole to their left. So all have a twin and a next.
 *
 * Invariants (half_edge_check):
 *  - twin(twin(h)) = h, twin(h) is not h, and at most one of the two is without a face;
 *  - origin(next(h)) = origin(twin(h)) and face(next(h)) = face(h);
 *  - the half edges of a face are one cycle of next, of at least 3;
 *  - the half edges that leave a vertex are one cycle of h -> next(twin(h)): one fan (manifold);
 *  - vertex_half_edge(v) leaves v (-1: v is isolated); where v is on the boundary, it is the one
 *    whose twin has no face, so that turning counter-clockwise from it meets every face of v;
 *  - face_half_edge(f) has face f.
 *
 * It refuses degenerate faces, edges with more than two faces, edges that two faces run through in
 * the same direction, and vertices whose faces are not one fan. It holds isolated vertices.
 *
 * Bytes: 16 a half edge (32 an edge), 4 a face, 16 a vertex (12 of them its position); a large
 * closed triangle mesh takes 60 a triangle. Accesses, for k corners of a face or k faces of a
 * vertex: a step 1; corners or neighbours of a face, faces or vertices around a vertex, is it an
 * edge: k. Edits are in half_edge_edit.h. */
#ifndef REFERENCE_REPRESENTATION_HALF_EDGE_H
#define REFERENCE_REPRESENTATION_HALF_EDGE_H

#include "reference/mesh/mesh.h"
#include "reference/representation/sides.h"

#include <stdbool.h>
#include <stdint.h>

struct half_edge {
    int32_t origin;
    int32_t twin;
    int32_t next;
    int32_t face; /* -1: none, beyond a boundary edge */
};

/* An element that an edit removed has HALF_EDGE_REMOVED as origin, half edge of its vertex or half
 * edge of its face, until half_edge_compact (half_edge_edit.h). A built mesh has none. */
enum { HALF_EDGE_REMOVED = -2 };

struct half_edge_mesh {
    float *positions;          /* 3 a vertex */
    int32_t *vertex_half_edge; /* one that leaves the vertex; -1: isolated */
    int32_t *face_half_edge;   /* the one that leaves the face's first corner */
    struct half_edge *half_edges;
    int32_t vertex_count, face_count, half_edge_count;          /* removed elements included */
    int32_t vertex_capacity, face_capacity, half_edge_capacity; /* room in the tables */
};

/* Builds from faces. Half edge s is side s of the faces (sides.h); the outer ones follow, in the
 * order of their twins.
 *
 * he         its old contents are not looked at; on success the caller owns it
 * positions  3 a vertex, copied
 * returns    0, or -1 and *err naming what it refuses (above), or out of memory; then *he is empty
 * cost       linear */
int half_edge_build(struct half_edge_mesh *he, const struct polygons *polygons,
                    const float *positions, struct error *err) MUST_CHECK;

/* Frees the tables and leaves the empty mesh; a zeroed one may be released. */
void half_edge_release(struct half_edge_mesh *he);

/* Checks the invariants. Returns 0, or -1 and *err naming the element at fault. Linear. */
int half_edge_check(const struct half_edge_mesh *he, struct error *err) MUST_CHECK;

/* The indexed mesh: vertices and faces in order, each face from its first corner. The caller owns
 * it. Returns 0, or -1 and *err: a face that is no triangle, removed elements, out of memory. */
int half_edge_to_mesh(const struct half_edge_mesh *he, struct mesh *mesh,
                      struct error *err) MUST_CHECK;

/* -- steps, one access each unless it says otherwise ----------------------------------------- */

static inline int32_t half_edge_end(const struct half_edge_mesh *he, int32_t h)
{
    return he->half_edges[he->half_edges[h].twin].origin;
}

/* The half edges that leave the same vertex before and after h: clockwise (2 accesses, crosses
 * holes), and counter-clockwise (h must have a face; k accesses for a face of k corners). */
static inline int32_t half_edge_turn_right(const struct half_edge_mesh *he, int32_t h)
{
    return he->half_edges[he->half_edges[h].twin].next;
}

static inline int32_t half_edge_turn_left(const struct half_edge_mesh *he, int32_t h)
{
    int32_t before = he->half_edges[h].next;
    while (he->half_edges[before].next != h)
        before = he->half_edges[before].next;
    return he->half_edges[before].twin;
}

/* The half edge before h in its face or around its hole: found around the face, or for a hole
 * around the vertex, since holes may be long. k accesses. */
int32_t half_edge_previous(const struct half_edge_mesh *he, int32_t h);

/* Whether a vertex is an end of a boundary edge. */
static inline bool half_edge_on_boundary(const struct half_edge_mesh *he, int32_t vertex)
{
    int32_t h = he->vertex_half_edge[vertex];
    return h >= 0 && he->half_edges[he->half_edges[h].twin].face < 0;
}

/* The half edge from u to v, or -1. Cost: the valence of u. */
int32_t half_edge_find(const struct half_edge_mesh *he, int32_t u, int32_t v);

/* Document 004's exercise 2: the half edges that leave a vertex, counter-clockwise; on a boundary
 * the last has no face. Writes at most `capacity` and returns how many there are. Cost k. */
int32_t half_edge_outgoing(const struct half_edge_mesh *he, int32_t vertex, int32_t *half_edges,
                           int32_t capacity);

#endif
