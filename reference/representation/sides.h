/* The sides of polygons and how they match: the first half of building every linked structure.
 *
 * A face is a cyclic sequence of vertices, counter-clockwise seen from outside. A side is one step
 * of it, from a vertex to the next; sides are numbered face after face, in the order of the
 * corners. The twin of a side is the side that runs between the same two vertices the other way.
 *
 *            3 ------------- 2       faces 0: 0 1 2, 1: 0 2 3
 *            | \ side 4      |       side  0: 0 -> 1   3: 0 -> 2
 *    side 5  |   \  side 2   | side 1      1: 1 -> 2   4: 2 -> 3
 *            |     \         |             2: 2 -> 0   5: 3 -> 0
 *            0 ------------- 1       twin of 2 is 3; the others are on the boundary: twin -1
 *                 side 0             (side 3 runs beside side 2) */
#ifndef REFERENCE_REPRESENTATION_SIDES_H
#define REFERENCE_REPRESENTATION_SIDES_H

#include "reference/mesh/mesh.h"

#include <stdint.h>

/* Faces with any number of corners, borrowed from the caller. */
struct polygons {
    const int32_t *corners;     /* vertex indices, face after face; each in [0, vertex_count) */
    const int32_t *face_starts; /* face f has corners face_starts[f] ... face_starts[f + 1] - 1, at
                         least 3; face_count + 1 entries. NULL: triangles, 3f ... 3f + 2 */
    int32_t vertex_count;
    int32_t face_count;
};

/* The faces of a mesh, as polygons; they borrow its table. */
struct polygons polygons_of_mesh(const struct mesh *mesh);

/* First corner of a face, and one past its last when asked for face + 1. */
static inline int32_t polygons_start(const struct polygons *polygons, int32_t face)
{
    return polygons->face_starts ? polygons->face_starts[face] : 3 * face;
}

/* Number of sides, which is also the number of corners. */
static inline int32_t polygons_side_count(const struct polygons *polygons)
{
    return polygons_start(polygons, polygons->face_count);
}

/* Finds the twin of every side.
 *
 * twin     polygons_side_count entries; -1 where the face has no neighbour
 * returns  0, or -1 and *err, which names the element: a face that names a vertex twice, an edge
 *          with more than two faces (non-manifold), an edge that two faces run through in the same
 *          direction (incoherent), or out of memory
 * cost     linear, whatever the valence. Triangles go through the fastest twins kernel of this
 *          machine (reference/kernels/twins.h). Where that finds fault, and for other faces, sides
 * are bucketed by their smaller vertex and within a bucket found by scan (few) or by marks on the
 * larger vertex (many); 24 bytes a triangle and 4 a vertex meanwhile. source   our own; bucketing
 * by the smaller vertex is folklore */
int sides_match(const struct polygons *polygons, int32_t *twin, struct error *err) MUST_CHECK;

/* Finds for every vertex the side that starts its fan: the one from which turning
 * counter-clockwise, side -> twin of the side before it in its face, meets every face of the
 * vertex. On a boundary it is the side without a twin; inside, the first one by number.
 *
 * twin     of sides_match
 * fan      vertex_count entries; -1 for a vertex without faces
 * returns  0, or -1 and *err: a vertex whose faces are not one fan (non-manifold), out of memory
 * cost     linear; 4 bytes a vertex meanwhile, and 4 a side where faces are not all triangles */
int sides_fans(const struct polygons *polygons, const int32_t *twin, int32_t *fan,
               struct error *err) MUST_CHECK;

#endif
