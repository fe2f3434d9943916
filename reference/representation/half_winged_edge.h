/* Half-winged edges (semiaristas aladas, course document 001): each edge is two half edges, and the
 * half edge keeps the normal and the texture coordinates that its face has at its start. So a
 * vertex may look different in each of its faces, as at the edge of a cube or at the seam of a
 * texture.
 *
 *                 end                  here       001      what it is
 *               / ^  \                 start      Vi       vertex where it starts
 *     next    /   |    \               end        Vf       vertex where it ends
 *           /     |      \             twin       H        the other half of the edge
 *         /  face |        \           face       C        the face to its left; -1: none
 *         \       | half   /           previous   Aa       the one before it in its face
 *           \     |      /             next       As       the one after it in its face
 *     previous \  |    /               normal     Normal   of the face at start, unit or zero
 *               \ |  /                 texture    (u,v)    of the face at start
 *    normal -> * start
 *    texture                           The two halves of edge e are e and e + edge_count; the
 *                                      first one runs as the face that names the edge first.
 *
 * Faces may have any number of corners. Beyond a boundary edge the half edge has face -1, no
 * normal, texture (0, 0), and is linked along the hole. The document writes edge numbers into Aa
 * and As; here they number half edges, which saves asking which way the edge is run. It also leaves
 * out the half edge of each vertex, without which every query about a vertex is a search; it is
 * kept here.
 *
 * Invariants (half_winged_edge_check): as in half_edge.h, and besides
 *  - end(h) = start(twin(h)), previous(next(h)) = h;
 *  - normals are finite, of length 1 or 0; texture coordinates are finite.
 *
 * It refuses degenerate faces, edges with more than two faces, edges that two faces run through in
 * the same direction, and vertices whose faces are not one fan. It holds isolated vertices.
 *
 * Bytes: 44 a half edge (88 an edge), 4 a face, 16 a vertex (12 of them its position); a large
 * closed triangle mesh takes 144 a triangle, of which 60 are normals and textures. Accesses, for k
 * corners of a face or k faces of a vertex: a step, a normal 1; corners or neighbours of a face,
 * around a vertex, is it an edge: k. */
#ifndef REFERENCE_REPRESENTATION_HALF_WINGED_EDGE_H
#define REFERENCE_REPRESENTATION_HALF_WINGED_EDGE_H

#include "reference/mesh/mesh.h"
#include "reference/representation/sides.h"

#include <stdbool.h>
#include <stdint.h>

struct half_winged_edge {
    int32_t start, end;
    int32_t twin;
    int32_t face; /* -1: none, beyond a boundary edge */
    int32_t previous, next;
    float normal[3];
    float texture[2];
};

struct half_winged_edge_mesh {
    float *positions;          /* 3 a vertex */
    int32_t *vertex_half_edge; /* where the fan starts (half_edge.h); -1: isolated */
    int32_t *face_half_edge;   /* the one that leaves the face's first corner */
    struct half_winged_edge *half_edges;
    int32_t vertex_count, face_count, half_edge_count;
};

/* Builds from faces.
 *
 * hw         its old contents are not looked at; on success the caller owns it
 * positions  3 a vertex, copied
 * normals    3 a side (sides.h), those at its start, unit or zero; NULL: smooth ones are computed
 *            (half_winged_edge_shade with 180 degrees)
 * textures   2 a side; NULL: all zero
 * returns    0, or -1 and *err naming what it refuses (above), or out of memory; then *hw is empty
 * cost       linear */
int half_winged_edge_build(struct half_winged_edge_mesh *hw, const struct polygons *polygons,
                           const float *positions, const float *normals, const float *textures,
                           struct error *err) MUST_CHECK;

/* Frees the tables and leaves the empty mesh; a zeroed one may be released. */
void half_winged_edge_release(struct half_winged_edge_mesh *hw);

/* Checks the invariants. Returns 0, or -1 and *err naming the element at fault. Linear. */
int half_winged_edge_check(const struct half_winged_edge_mesh *hw, struct error *err) MUST_CHECK;

/* The indexed mesh: vertices and faces in order, each face from its first corner; normals and
 * textures are left behind. The caller owns it. Returns 0, or -1 and *err: a face that is no
 * triangle, out of memory. */
int half_winged_edge_to_mesh(const struct half_winged_edge_mesh *hw, struct mesh *mesh,
                             struct error *err) MUST_CHECK;

/* -- normals (half_winged_edge_shading.c) ----------------------------------------------------- */

/* Sets every normal: around each vertex the faces are cut into groups at the boundary and at
 * creases, the edges whose two faces turn by more than `crease_degrees` (0 ... 180); each corner of
 * a group gets the unit sum of the group's area vectors. 180 is smooth, 0 is flat but for planes.
 * Returns 0, or -1 and *err (out of memory: 24 bytes a face). Cost: linear. */
int half_winged_edge_shade(struct half_winged_edge_mesh *hw, double crease_degrees,
                           struct error *err) MUST_CHECK;

/* Area vector of a face with any number of corners (Newell's method), twice its area long. */
void half_winged_edge_area_vector(const struct half_winged_edge_mesh *hw, int32_t face,
                                  double vector[3]);

/* How many vertices a renderer needs, which has one normal and one texture coordinate a vertex: the
 * different (normal, texture) around each vertex, neighbours in a fan compared. Document 000's cube
 * has 8 vertices and needs 24. Cost: linear. */
int64_t half_winged_edge_render_vertices(const struct half_winged_edge_mesh *hw);

/* -- steps ------------------------------------------------------------------------------------ */

/* The half edges that leave the same vertex, counter-clockwise and clockwise; two accesses each. */
static inline int32_t half_winged_edge_turn_left(const struct half_winged_edge_mesh *hw, int32_t h)
{
    return hw->half_edges[hw->half_edges[h].previous].twin;
}

static inline int32_t half_winged_edge_turn_right(const struct half_winged_edge_mesh *hw, int32_t h)
{
    return hw->half_edges[hw->half_edges[h].twin].next;
}

/* Whether a vertex is an end of a boundary edge. */
static inline bool half_winged_edge_on_boundary(const struct half_winged_edge_mesh *hw,
                                                int32_t vertex)
{
    int32_t h = hw->vertex_half_edge[vertex];
    return h >= 0 && hw->half_edges[hw->half_edges[h].twin].face < 0;
}

#endif
