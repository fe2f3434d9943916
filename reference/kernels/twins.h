/* Twins of the half edges of a mesh.
 *
 * Side 3t + k of triangle t runs from its corner k to the next one: it is the half edge of that
 * triangle. Its twin is the side that runs the other way along the same edge.
 *
 * Output   int32_t for each side, 3 * triangle_count of them. For a side from i to j:
 *            the twin        where it is the only side from i to j and just one runs from j to i
 *            TWIN_NONE (-1)  where none runs from j to i: a boundary, or a neighbour that is
 *                            oriented incoherently
 *            TWIN_MANY (-2)  where some run from j to i, and several there or from i to j: the edge
 *                            is not manifold, or the triangles there are incoherent
 *          So twin[twin[s]] == s wherever twin[s] >= 0, and the answer depends on no order. A
 *          side that joins a vertex to itself has TWIN_NONE.
 * Scratch  rows of 129 bytes a vertex, mostly only 65 touched, and room for high valences
 * Cost     linear in vertices and triangles, whatever the valences and the numbering. 12 ns a
 *          triangle ordered and 41 scrambled with AVX-512, 23 and 58 in plain C (2M triangles,
 *          Zen 4); when scrambled, 17 of that are the writing of twins at random places
 * Source   buckets at vertices as in Campagna, Kobbelt and Seidel, Directed Edges (1998); rows
 *          of both directions that are matched once they are full (side_rows.h), so that what
 *          is not manifold is seen for nothing, and the sorting into parts, are ours
 * Rejected a list for each vertex (15 and 500 ns, on another machine); rows of the sides that
 *          leave a vertex, filled in one pass and searched in another (10.5 and 130); matching
 *          as sides come (19 and 44) */
#ifndef REFERENCE_KERNELS_TWINS_H
#define REFERENCE_KERNELS_TWINS_H

#include "reference/kernels/kernel.h"

enum { TWIN_NONE = -1, TWIN_MANY = -2 };

size_t twins_scratch_bytes(int64_t vertex_count, int64_t triangle_count);
size_t twins_output_bytes(int64_t vertex_count, int64_t triangle_count);
int64_t twins_moved_bytes(int64_t vertex_count, int64_t triangle_count, int64_t side_count);

/* The contract of kernel.h; returns the number of sides. */
int64_t twins_plain(const struct mesh *mesh, void *scratch, void *output);
#if defined(__x86_64__)
int64_t twins_avx2(const struct mesh *mesh, void *scratch, void *output);
int64_t twins_avx512(const struct mesh *mesh, void *scratch, void *output);
#endif

/* On a given number of threads, of the same scratch. */
int64_t twins_on_threads(const struct mesh *mesh, void *scratch, void *output, int thread_count);

/* What every variant does, given how it fills rows and how it matches the rows begin ... end - 1,
 * but those with an overflow (side_rows.h). */
struct side_rows;
int64_t twins_by(struct side_rows (*fill)(const struct mesh *mesh, void *scratch),
                 void (*match)(const struct side_rows *rows, int32_t begin, int32_t end,
                               int32_t *twin),
                 const struct mesh *mesh, void *scratch, int32_t *twin);
void twins_match(const struct side_rows *rows, int32_t begin, int32_t end, int32_t *twin);
#if defined(__x86_64__)
void twins_match_avx2(const struct side_rows *rows, int32_t begin, int32_t end, int32_t *twin);
void twins_match_avx512(const struct side_rows *rows, int32_t begin, int32_t end, int32_t *twin);
#endif

#endif
