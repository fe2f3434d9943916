/* Edge table of a closed, coherently oriented mesh (the course's problem 4.5 b).
 *
 * Each edge is met twice, once as (i,j) and once as (j,i); keeping only the sides with i < j
 * lists it once. No search and no memory beside the table.
 *
 * Output   pairs of int32_t (i, j), i < j, by triangle and then by side (0,1), (1,2), (2,0);
 *          3/2 triangle_count of them. On a mesh that is not closed and coherent, just the
 *          sides with i < j, at most 2 a triangle, which is what the capacity allows.
 * Scratch  none but for threads
 * Cost     one pass; moves 24 bytes a triangle. 0.9 ns a triangle with AVX2 or AVX-512, 1.7 in
 *          plain C (2M triangles, Zen 4), in any order. When the output begins 0 to 256 bytes
 *          after the triangles modulo 4096, a regular mesh takes up to twice that: stores then
 *          run ahead of loads in the low bits of their addresses, by which processors guess
 *          what depends on what.
 * Source   folklore of half-edge codes; the branch-free form and the vector ones are ours
 * Rejected a branch for each side (8 to 11 ns without order); stores past the caches (slower
 *          below 64 MB); blocks written aside and copied, against the guessing above (1.3 for
 *          1.7 ns when it strikes, else 1.8 for 0.9) */
#ifndef REFERENCE_KERNELS_EDGES_CLOSED_H
#define REFERENCE_KERNELS_EDGES_CLOSED_H

#include "reference/kernels/kernel.h"

size_t edges_closed_output_bytes(int64_t vertex_count, int64_t triangle_count);
int64_t edges_closed_moved_bytes(int64_t vertex_count, int64_t triangle_count, int64_t edge_count);

/* The contract of kernel.h; returns the number of edges. */
int64_t edges_closed_plain(const struct mesh *mesh, void *scratch, void *output);
#if defined(__x86_64__)
int64_t edges_closed_avx2(const struct mesh *mesh, void *scratch, void *output);
int64_t edges_closed_avx512(const struct mesh *mesh, void *scratch, void *output);
#endif

/* On a given number of threads; needs scratch. */
size_t edges_closed_threads_scratch_bytes(int64_t vertex_count, int64_t triangle_count);
int64_t edges_closed_on_threads(const struct mesh *mesh, void *scratch, void *output,
                                int thread_count);

/* How many sides of the triangles run upwards. */
int64_t edges_closed_count(const int32_t *triangles, int32_t triangle_count);
#if defined(__x86_64__)
int64_t edges_closed_count_avx2(const int32_t *triangles, int32_t triangle_count);
int64_t edges_closed_count_avx512(const int32_t *triangles, int32_t triangle_count);
#endif

#endif
