/* Answers in a form that does not depend on the order in which a program happens to give them, so
 * that programs can be held against each other (worker_answer in bench/measure/worker.h).
 *
 * What is computed for a vertex, edge or triangle counts with its name: an answer in which two of
 * them are exchanged is another one. A name is the element's number, or where programs number them
 * differently something made of its position.
 *
 * Peers written in C++ use this too. */
#ifndef BENCH_COMPARE_ANSWERS_H
#define BENCH_COMPARE_ANSWERS_H

#include "bench/measure/worker.h"
#include "reference/mesh/mesh.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Names: of a vertex by its position; of a triangle by its corners' names, rotated as it may be but
 * not turned over. */
uint64_t answer_position_name(const float position[3]);
uint64_t answer_triangle_name(uint64_t a, uint64_t b, uint64_t c);

/* Well mixed bits: sums of these over a set tell sets apart. */
uint64_t answer_mix(uint64_t bits);

/* A set of undirected edges: `pairs` holds edge_count times two vertices, in any order. `names` of
 * vertices here and below: NULL when they are called by their numbers. */
void answer_edges(struct worker_answer *answer, const int32_t *pairs, int64_t edge_count);
void answer_edges_named(struct worker_answer *answer, const int32_t *pairs, int64_t edge_count,
                        const uint64_t *names);

/* A set of triangles, rotated as they may be; degenerate ones do not count. */
void answer_triangles(struct worker_answer *answer, const int32_t *triangles, int64_t count);

/* A sum of areas: agrees within 10^-6. */
void answer_area(struct worker_answer *answer, double area);

/* Vectors of 3 floats, about as long as 1: normals or positions of the `count` vertices or faces.
 * What is compared is their sum with weights of -1 ... 1 by name and coordinate, over the root of
 * the count: it differs by about the root of the mean squared difference of the vectors, which is
 * to be 10^-4 at most, so that two that are exchanged show unless there are a hundred million. */
void answer_normals(struct worker_answer *answer, const float *normals, int64_t count);
void answer_positions(struct worker_answer *answer, const float *positions, int64_t count);
void answer_vectors_named(struct worker_answer *answer, const float *vectors, int64_t count,
                          const uint64_t *names);

/* Normals of vertices by another definition than ours (vertex_normals_plain), of a mesh with as
 * many vertices: where the mean cosine of the angles between both is at least 0.95 the answer is
 * what ours gives, else what they give. Out of memory leaves it out. */
void answer_normals_about(struct worker_answer *answer, const float *normals,
                          const struct mesh *mesh);

/* A number that must be the same. */
void answer_count(struct worker_answer *answer, int64_t count);

/* The neighbour (a triangle; < 0: none) across each of a triangle's three sides: side 0 runs from
 * corner 0 to 1. */
void answer_neighbours(struct worker_answer *answer, const int32_t *neighbours,
                       int64_t triangle_count);

/* A mesh that was read: the positions of the corners of its triangles, 9 floats each, in the order
 * of the file; vertices may be merged or numbered anew, triangles rotated. The hash is of their
 * exact bits; the value allows for differences in the last bit, for a peer that clears the hash. */
void answer_read_mesh(struct worker_answer *answer, const float *corners, int64_t triangle_count);

/* Strips, parted by STRIP_RESTART (stripify.h), hold a set of triangles; fact `indices`. An order
 * of triangles holds the same set; fact `cache_misses` (vertices that a first-in-first-out cache of
 * 16 does not hold when they are used). triangles: 3 a triangle, on vertices 0 ... vertex_count
 * - 1. Out of memory leaves the set or the fact out. */
void answer_strips(struct worker_answer *answer, const int32_t *indices, int64_t index_count);
void answer_order(struct worker_answer *answer, int32_t *triangles, int32_t triangle_count,
                  int32_t vertex_count);

/* Whether two programs agree: equal hashes where both have one, equal values where both have one.
 * Returns 1: they agree, 0: they differ, -1: they have nothing that can be compared. */
int answers_agree(const struct worker_answer *left, const struct worker_answer *right);

#ifdef __cplusplus
}
#endif

#endif
