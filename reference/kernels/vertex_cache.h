/* Orders of a mesh for processors that keep the latest vertices that they have processed: triangles
 * such that a vertex is used again while it is still kept, and vertices such that they are fetched
 * in the order of their first use.
 *
 * A cache of k vertices, first in first out, is the model. What counts is the average cache miss
 * ratio, vertices processed per triangle: 3 when nothing is used again, 1/2 at best on a closed
 * mesh, whose vertices are half as many as its triangles. */
#ifndef REFERENCE_KERNELS_VERTEX_CACHE_H
#define REFERENCE_KERNELS_VERTEX_CACHE_H

#include "reference/kernels/kernel.h"

enum { VERTEX_CACHE_SIZE = 16 }; /* that the kernel orders for; good for larger ones too */

size_t vertex_cache_scratch_bytes(int64_t vertex_count, int64_t triangle_count);
size_t vertex_cache_output_bytes(int64_t vertex_count, int64_t triangle_count);
int64_t vertex_cache_moved_bytes(int64_t vertex_count, int64_t triangle_count,
                                 int64_t triangle_records);

/* The triangles in such an order. Contract of kernel.h; output is 3 int32_t a triangle, the rows of
 * mesh->triangles as they are, each once; returns triangle_count.
 *
 * Source: tipsify, by Sander, Nehab and Barczak (Fast Triangle Reordering for Vertex Locality and
 * Reduced Overdraw, 2007).
 * Cost: linear, whatever the valences */
int64_t vertex_cache_plain(const struct mesh *mesh, void *scratch, void *output);

size_t vertex_fetch_output_bytes(int64_t vertex_count, int64_t triangle_count);
int64_t vertex_fetch_moved_bytes(int64_t vertex_count, int64_t triangle_count,
                                 int64_t vertex_records);

/* The new number of each vertex, int32_t, by first use; vertices without triangles come last, in
 * their present order. Contract of kernel.h, without scratch; returns vertex_count. Linear.
 *
 * Source: ours; renumbering by first use is common practice. */
int64_t vertex_fetch_plain(const struct mesh *mesh, void *scratch, void *output);

/* Vertices that a cache of cache_size (>= 1), first in first out, does not hold when they are used.
 *
 * scratch  room for vertex_count int64_t, of any content
 * cost     linear */
int64_t vertex_cache_misses(const struct mesh *mesh, int64_t cache_size, int64_t *scratch);

/* Puts a mesh into both orders. Returns 0, or -1 and *err (out of memory); then it is as it was. */
int vertex_cache_order(struct mesh *mesh, struct error *err) MUST_CHECK;

#endif
