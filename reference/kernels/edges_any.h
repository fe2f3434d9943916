/* Edge table of any mesh (the course's problem 4.5 a): open, of any orientation, non-manifold.
 *
 * Output   pairs of int32_t (i, j), i < j, each edge once: by i; among equal i in the order of the
 *          triangles that use them first; in one triangle the smaller j first. A side that joins a
 *          vertex to itself is no edge.
 * Cost     linear in vertices and triangles, whatever the valences and the numbering */
#ifndef REFERENCE_KERNELS_EDGES_ANY_H
#define REFERENCE_KERNELS_EDGES_ANY_H

#include "reference/kernels/kernel.h"

size_t edges_any_scratch_bytes(int64_t vertex_count, int64_t triangle_count);
size_t edges_any_output_bytes(int64_t vertex_count, int64_t triangle_count);
int64_t edges_any_moved_bytes(int64_t vertex_count, int64_t triangle_count, int64_t edge_count);

/* The contract of kernel.h; returns the number of edges. */
int64_t edges_any_plain(const struct mesh *mesh, void *scratch, void *output);
#if defined(__x86_64__)
int64_t edges_any_avx2(const struct mesh *mesh, void *scratch, void *output);
int64_t edges_any_avx512(const struct mesh *mesh, void *scratch, void *output);
#endif

/* What every variant does, given how it puts the edges of rows (neighbour_rows.h). */
struct neighbour_rows;
int64_t edges_any_by(int32_t *(*put)(const struct neighbour_rows *rows, int32_t begin, int32_t end,
                                     int32_t *edges),
                     const struct mesh *mesh, void *scratch, void *output);

/* On a given number of threads; needs more scratch. */
size_t edges_any_threads_scratch_bytes(int64_t vertex_count, int64_t triangle_count);
int64_t edges_any_on_threads(const struct mesh *mesh, void *scratch, void *output,
                             int thread_count);

#endif
