/* Winged edges of a mesh of polygons (Baumgart 1975; course document 001). */
#ifndef WINGED_EDGE_BUILD_H
#define WINGED_EDGE_BUILD_H

#include <stdint.h>

/* What the function returns instead of a count: malloc, calloc or realloc gave NULL; or the faces
 * cannot be held by winged edges. */
enum { OUT_OF_MEMORY = -1, NOT_MANIFOLD = -2, NOT_ORIENTABLE = -3 };

/* Where a table would name a face or an edge that is not there. */
enum { NONE = -1 };

/* One row of the table of edges.
 *
 *            |                vi, vf    the vertices that it joins, from vi to vf
 *     ads   vf   aia          cd        the face that runs it from vi to vf, to its left
 *       \____|____/           ci        the face that runs it from vf to vi, to its right
 *            |                ada, ads  the edge before it and the one after it in cd
 *        cd  |  ci            aia, ais  the edge before it and the one after it in ci
 *        ____|____
 *       /    |    \           Before and after are meant as the face is run, and faces are run
 *     ada   vi   ais          counter-clockwise: in cd, ada ends at vi and ads begins at vf; in ci,
 *            |                aia ends at vf and ais begins at vi.
 *
 * On a boundary edge one of the two faces is NONE, and so are its two links. */
struct winged_edge {
    int32_t vi, vf, cd, ci, ada, ads, aia, ais;
};

/* Makes the winged edges of a mesh: every edge of the faces once, numbered in any order, vi and vf
 * either way round.
 *
 * first_corner  face_count + 1 offsets: face f has the vertices corners[first_corner[f]] ...
 *               corners[first_corner[f + 1] - 1], counter-clockwise seen from outside;
 *               first_corner[0] is 0. Must not be followed when face_count is 0.
 * corners       vertex numbers from 0 to vertex_count - 1. A face has 3 or more, all different.
 *               Neither table can be written. Must not be followed when face_count is 0.
 * face_count    number of faces, 0 or more
 * vertex_count  number of vertices, 0 or more. Some may be in no face.
 * edges         where to store the table: an array made with malloc (or calloc, realloc). The
 *               caller frees it with free(). It may be longer than needed, and NULL when there is
 *               no edge.
 * vertex_edge   an array of the caller's with vertex_count entries, to be filled: any edge at the
 *               vertex; NONE when no face has the vertex
 * face_edge     the same with face_count entries: any edge of the face
 *
 * returns       the number of edges; or OUT_OF_MEMORY; or
 *               NOT_MANIFOLD    when an edge has three faces or more, whichever way they run it, or
 *                               the faces at a vertex are not one fan: going from face to face over
 *                               the edges at the vertex does not meet all of them;
 *               NOT_ORIENTABLE  when an edge has two faces that run it the same way.
 *               No mesh is both. After one of these three nothing that the function made is left,
 *               and the tables are not looked at.
 * cost          time and memory proportional to the number of corners, but for a logarithm at most.
 *               No vertex has more than a constant number of edges; you are not told it. */
int32_t winged_edge_build(const int32_t *first_corner, const int32_t *corners, int32_t face_count,
                          int32_t vertex_count, struct winged_edge **edges, int32_t *vertex_edge,
                          int32_t *face_edge);

#endif
