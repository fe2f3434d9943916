/* Neighbours by winged edges: seven queries (course document 001, navigation graph). */
#ifndef ADJACENCY_QUERIES_H
#define ADJACENCY_QUERIES_H

#include <stdint.h>

/* One row of the table of edges.
 *
 *            |                vi, vf    the vertices that it joins, from vi to vf
 *     ads   vf   aia          cd        the face that runs it from vi to vf, to its left
 *       \____|____/           ci        the face that runs it from vf to vi, to its right
 *            |                ada, ads  the edge before it and the one after it in cd
 *        cd  |  ci            aia, ais  the edge before it and the one after it in ci
 *        ____|____
 *       /    |    \           Before and after are meant as the face is run, and faces are run
 *     ada   vi   ais          counter-clockwise, seen from outside: in cd, ada ends at vi and ads
 *            |                begins at vf; in ci, aia ends at vf and ais begins at vi. */
struct winged_edge {
    int32_t vi, vf, cd, ci, ada, ads, aia, ais;
};

/* Given to you: call them, and do not define them. They are the only way to the structure. Each
 * call is one access, and accesses are counted. The mesh is closed: every edge has two faces, every
 * vertex has edges. */
struct winged_edge row_of_edge(int32_t edge);
int32_t edge_of_vertex(int32_t vertex); /* one of the edges at the vertex, any */
int32_t edge_of_face(int32_t face);     /* one of the edges of the face, any */

/* What you write: seven functions. Each lists what touches one element of the mesh.
 *
 * edge, face, vertex  the element that is asked for; it exists
 * out                 where to write the numbers of what is found
 * capacity            room in `out`: more than the answer needs
 * returns             how many there are
 *
 * Nothing may be kept from one call to the next: no static variables, no memory that stays. No
 * query needs malloc. The cost is in proportion to what is listed, not to the mesh. */

/* In the order in which the face is run, counter-clockwise, starting anywhere. A face has 3 corners
 * or more. faces_of_face has an entry for each edge of the face, the face on its other side: one
 * that shares two edges with the face is listed twice. */
int32_t edges_of_face(int32_t face, int32_t *out, int32_t capacity);
int32_t vertices_of_face(int32_t face, int32_t *out, int32_t capacity);
int32_t faces_of_face(int32_t face, int32_t *out, int32_t capacity);

/* In any order, each once. edges_of_edge lists the edges that have a vertex in common with the edge,
 * at either end, and not the edge itself; vertices_of_vertex the other ends of the vertex's edges. */
int32_t edges_of_vertex(int32_t vertex, int32_t *out, int32_t capacity);
int32_t faces_of_vertex(int32_t vertex, int32_t *out, int32_t capacity);
int32_t vertices_of_vertex(int32_t vertex, int32_t *out, int32_t capacity);
int32_t edges_of_edge(int32_t edge, int32_t *out, int32_t capacity);

#endif
