/* A structure of your own that answers what touches a vertex or a face without a search. */
#ifndef OWN_STRUCTURE_H
#define OWN_STRUCTURE_H

#include <stdint.h>

/* Yours: define it in your file as you like. */
struct structure;

/* Builds the structure of a closed mesh: every edge has two faces, which run it in opposite
 * directions, and the faces at a vertex are one fan.
 *
 * first_corner  face_count + 1 offsets: face f has the vertices corners[first_corner[f]] ...
 *               corners[first_corner[f + 1] - 1], counter-clockwise seen from outside, three or
 *               more, all different
 * corners       vertex numbers from 0 to vertex_count - 1. Both tables stay where they are until
 *               structure_release, and cannot be written.
 * face_count    number of faces, 4 or more
 * vertex_count  number of vertices; each is in three faces or more, and in no more than a constant
 *               number of them that does not depend on the size of the mesh
 *
 * returns       the structure, made with malloc (or calloc, realloc); NULL when memory runs out, and
 *               then nothing is left
 * cost          time and memory proportional to the number of corners, but for a logarithm of time
 *               at most */
struct structure *structure_build(const int32_t *first_corner, const int32_t *corners,
                                  int32_t face_count, int32_t vertex_count);

/* Frees a structure. */
void structure_release(struct structure *structure);

/* The faces that have the vertex, each once, in any order; and for each edge of a face, in the order
 * in which the face is run, beginning with any, the face on its other side.
 *
 * out       where to write the numbers of the faces
 * capacity  room in `out`: more than the answer needs
 * returns   how many there are
 * cost      in proportion to what is listed, not to the mesh; no memory */
int32_t faces_of_vertex(const struct structure *structure, int32_t vertex, int32_t *out,
                        int32_t capacity);
int32_t faces_of_face(const struct structure *structure, int32_t face, int32_t *out,
                      int32_t capacity);

#endif
