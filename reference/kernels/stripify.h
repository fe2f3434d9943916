/* An indexed mesh as one sequence of indices of triangle strips, long ones.
 *
 * A strip v0 v1 v2 v3 v4 ... holds the triangles (v0 v1 v2), (v2 v1 v3), (v2 v3 v4), ...: every
 * second one is wound the other way, so that all are seen from their own side. A triangle costs one
 * index where the strip turns left and right in turn,
 *
 *        v1---v3---v5              two where it turns the same way twice: then an older vertex is
 *        /\   /\   /\              repeated (v0 v1 v2 v1 v3), which makes a triangle without area,
 *       /  \ /  \ /  \             and four where a new strip starts (three corners and the joint).
 *      v0---v2---v4---v6
 *
 * Algorithm: a greedy walk over twins (twins.h), ours; each strip starts beside the strips before
 * it, at the triangle that was passed by last, and leaves that through the side whose neighbour has
 * the fewest free neighbours (after Akeley, Haeberli and Burns' tomesh, 1990). The triangles need
 * no order beforehand.
 * Cost: linear in vertices and triangles; half of it and more are the twins. Measured beside
 * meshoptimizer 0.18 on tori, spheres, scans and models of 1,000 to 2,000,000 triangles: from 0.5 %
 * more to 11 % fewer indices, four to twelve times faster than its ordering for strips and its
 * stripify together, up to three times slower than the latter alone. */
#ifndef REFERENCE_KERNELS_STRIPIFY_H
#define REFERENCE_KERNELS_STRIPIFY_H

#include "reference/kernels/kernel.h"

/* Between strips; the restart index of OpenGL, Vulkan and WebGL for 32-bit indices is this value
 * too. */
enum { STRIP_RESTART = -1 };

size_t stripify_scratch_bytes(int64_t vertex_count, int64_t triangle_count);
size_t stripify_output_bytes(int64_t vertex_count, int64_t triangle_count);
int64_t stripify_moved_bytes(int64_t vertex_count, int64_t triangle_count, int64_t index_count);

/* The contract of kernel.h. Output: int32_t indices, strips parted by STRIP_RESTART, at most
 * 4 * triangle_count; returns how many. Every triangle comes once, rotated but not turned over;
 * those that are degenerate in the mesh too, though nothing tells them from the joints. The
 * variants differ in how they find twins. */
int64_t stripify_plain(const struct mesh *mesh, void *scratch, void *output);
#if defined(__x86_64__)
int64_t stripify_avx512(const struct mesh *mesh, void *scratch, void *output);
#endif

/* The same strips as one, for where there is no restart index: joined by repeating the last index
 * and the next first one, that one twice where the winding asks for it.
 *
 * indices  `count` of them, as from stripify
 * joined   room for 2 * count, not overlapping indices
 * returns  how many indices stand in joined
 * cost     linear */
int64_t strips_join(const int32_t *indices, int64_t count, int32_t *joined);

/* The triangles of either sequence, in order, without the degenerate ones.
 *
 * triangles  room for 3 * count
 * returns    how many triangles
 * cost       linear */
int64_t strips_triangles(const int32_t *indices, int64_t count, int32_t *triangles);

#endif
