/* The boundary loops of an indexed triangle mesh. */
#ifndef BOUNDARY_LOOPS_H
#define BOUNDARY_LOOPS_H

#include <stdint.h>

/* What a function of these exercises returns when malloc, calloc or realloc gave NULL. */
enum { OUT_OF_MEMORY = -1 };

/* Makes the loops that the boundary of a triangle mesh consists of. A boundary edge belongs to just
 * one triangle. A loop is a cyclic sequence of vertices: from each of them a boundary edge leads to
 * the next one, and from the last to the first, always in the direction in which the edge's
 * triangle runs it, so that the surface lies to the left. Every boundary edge is in exactly one
 * loop, once. Loops stand in any order, and each begins at any of its vertices.
 *
 * Promised: no edge has more than two triangles, the orientation is coherent (the two triangles of
 * an edge run it in opposite directions), and no triangle repeats a vertex. The mesh may be closed,
 * open, in several components, empty, and have vertices that no triangle uses. Fans of triangles
 * may share a single vertex; more than one choice of loops exists there, and each is right.
 *
 * triangles        triangle_count triples of vertex numbers: triangle t runs from triangles[3*t] to
 *                  triangles[3*t+1], to triangles[3*t+2], and back. Each is from 0 to
 *                  vertex_count - 1. Cannot be written. Must not be followed when triangle_count
 *                  is 0.
 * triangle_count   number of triangles, 0 or more
 * vertex_count     number of vertices, 0 or more. No vertex has more than a constant number of
 *                  neighbours, which does not depend on vertex_count; you are not told it.
 * first            where to store the offsets: an array made with malloc (or calloc, realloc), with
 *                  one entry more than there are loops. (*first)[0] is 0, and the vertices of loop
 *                  l are (*vertices)[(*first)[l]] ... (*vertices)[(*first)[l + 1] - 1].
 * vertices         where to store the vertices, loop after loop: an array made likewise. The first
 *                  vertex of a loop is not repeated at its end.
 *                  The caller frees both with free(). They may be longer than needed. When there
 *                  is no loop they may be NULL, and are not looked at.
 *
 * returns          the number of loops; or OUT_OF_MEMORY, and then nothing that the function made
 *                  is left, and *first and *vertices are not looked at
 * cost             time and memory proportional to the size of the mesh, but for a logarithm at
 *                  most */
int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices);

#endif
