/* Area of a mesh (the course's problem 4.6): half the length of the cross product of two sides
 * of each triangle, summed.
 *
 * Output   one double: the sum over all triangles
 * Bound    every variant computes each triangle in binary64 from binary32 positions, with the
 *          same roundings, and adds in binary64; the variants differ in the order of adding
 *          only. Two of them therefore differ by at most 2^-52 (triangle_count + 1) times the
 *          area, and in practice by some 1e-15 of it. Each gives the same bits on every run;
 *          threads for one number of threads.
 * Scratch  none but for threads
 * Cost     one pass; moves 12 bytes a triangle and 12 a vertex. 1.8 ns a triangle with
 *          AVX-512, 3.3 with AVX2, 4.7 in plain C (2M triangles, Zen 4); scrambled 21 to 25
 *          and 31
 * Source   ours
 * Rejected binary32 up to the sum (1.3 ns), which loses needles, and lengths whose squares
 *          leave the range of binary32; gathers (4 ns); no prefetch when scattered (56 ns) */
#ifndef REFERENCE_KERNELS_AREA_H
#define REFERENCE_KERNELS_AREA_H

#include "reference/kernels/kernel.h"

size_t area_output_bytes(int64_t vertex_count, int64_t triangle_count);
int64_t area_moved_bytes(int64_t vertex_count, int64_t triangle_count, int64_t record_count);

/* The contract of kernel.h; returns 1. */
int64_t area_plain(const struct mesh *mesh, void *scratch, void *output);
#if defined(__x86_64__)
int64_t area_avx2(const struct mesh *mesh, void *scratch, void *output);
int64_t area_avx512(const struct mesh *mesh, void *scratch, void *output);
#endif

/* On a given number of threads; needs scratch. */
size_t area_threads_scratch_bytes(int64_t vertex_count, int64_t triangle_count);
int64_t area_on_threads(const struct mesh *mesh, void *scratch, void *output, int thread_count);

#endif
