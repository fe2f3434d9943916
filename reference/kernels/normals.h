/* Normals of a mesh, of length 1, pointing to where the triangle is seen counter-clockwise.
 *
 * face-normals
 *   Output   3 floats for each triangle: (b - a) x (c - a) made of length 1, computed in
 *            binary64 and rounded once. A triangle without area has (0, 0, 0).
 *   Source   the cross product of two sides is the textbook's; the kernels are ours
 *   Cost     one pass. 2.5 ns a triangle with AVX-512, 4.5 with AVX2, 6.8 in plain C
 *
 * vertex-normals
 *   Output   3 floats for each vertex: the sum of (b - a) x (c - a) over the triangles at the
 *            vertex, each of which so counts by its area, in binary32 and in the order of the
 *            triangles; made of length 1. A vertex where the sum is 0 has (0, 0, 0).
 *   Scratch  the sums, 16 bytes a vertex
 *   Cost     one pass over the triangles, one over the vertices. 4.3 ns a triangle with AVX2,
 *            6.3 in plain C; scrambled 45 to 60 and 54 to 64 (2M triangles, Zen 4)
 *   Source   weighting by area is Gouraud's (1971), as commonly done; the kernels are ours
 *   AVX-512  has no variant: to keep the order of adding, triangles come one after the other, and a
 *            sum is four floats wide; nothing would gain by longer vectors
 *   Rejected threads that each own some vertices, the way to keep the order of adding: 4.2 ns on
 *            two threads and scrambled 60, as each must compute nearly all products */
#ifndef REFERENCE_KERNELS_NORMALS_H
#define REFERENCE_KERNELS_NORMALS_H

#include "reference/kernels/kernel.h"

size_t face_normals_output_bytes(int64_t vertex_count, int64_t triangle_count);
int64_t face_normals_moved_bytes(int64_t vertex_count, int64_t triangle_count,
                                 int64_t normal_count);

/* The contract of kernel.h; returns the number of triangles. */
int64_t face_normals_plain(const struct mesh *mesh, void *scratch, void *output);
#if defined(__x86_64__)
int64_t face_normals_avx2(const struct mesh *mesh, void *scratch, void *output);
int64_t face_normals_avx512(const struct mesh *mesh, void *scratch, void *output);
#endif
int64_t face_normals_on_threads(const struct mesh *mesh, void *scratch, void *output,
                                int thread_count);

size_t vertex_normals_scratch_bytes(int64_t vertex_count, int64_t triangle_count);
size_t vertex_normals_output_bytes(int64_t vertex_count, int64_t triangle_count);
int64_t vertex_normals_moved_bytes(int64_t vertex_count, int64_t triangle_count,
                                   int64_t normal_count);

/* The contract of kernel.h; returns the number of vertices. */
int64_t vertex_normals_plain(const struct mesh *mesh, void *scratch, void *output);
#if defined(__x86_64__)
int64_t vertex_normals_avx2(const struct mesh *mesh, void *scratch, void *output);
#endif

/* (b - a) x (c - a) in binary32. */
static inline void triangle_cross(const float *positions, const int32_t t[3], float cross[3])
{
    const float *a = positions + 3 * (size_t)t[0], *b = positions + 3 * (size_t)t[1];
    const float *c = positions + 3 * (size_t)t[2];
    float ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
    float vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
    cross[0] = uy * vz - uz * vy;
    cross[1] = uz * vx - ux * vz;
    cross[2] = ux * vy - uy * vx;
}

/* The normal of one vertex, of its sum. */
void vertex_normal_write(const float sum[3], float normal[3]);

#endif
