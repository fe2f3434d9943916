/* Edge table of any mesh (the course's problem 4.5 a): open, of any orientation, non-manifold.
 *
 * Output   pairs of int32_t (i, j), i < j, each edge once: by i; among equal i in the order of
 *          the triangles that use them first; in one triangle the smaller j first. A side that
 *          joins a vertex to itself is no edge, the other sides of its triangle are ("of the
 *          table" in reference/mesh/edges.h).
 * Scratch  rows of 65 bytes a vertex, and room for high valences that is seldom touched. A
 *          large scattered mesh uses the rows of a thousand vertices at a time, and the output
 *          as work space before it is one.
 * Cost     linear in vertices and triangles, whatever the valences and the numbering. 6 ns a
 *          triangle ordered and 16 scrambled with AVX-512, 12 and 24 in plain C (2M triangles,
 *          Zen 4)
 * Source   buckets by the smaller vertex are the textbook's; rows that take everything and are
 *          looked through once at the end (neighbour_rows.h), and the sorting into parts, are
 *          ours
 * Rejected counting sort by the smaller vertex (10 and 44 ns); search before adding (8 to 9
 *          and 24 to 78); a hash of the edges (15 and 38, on another machine); proof by a
 *          signed sum of hashes that the mesh is closed and coherent (1.8), which two sides
 *          each way of a non-manifold edge deceive; matching within the last triangles (4.6),
 *          which needs a manifold too */
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
