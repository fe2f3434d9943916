/* Answers in a form that does not depend on the order in which a program happens to give them, so
 * that programs can be held against each other (worker_answer in bench/measure/worker.h).
 *
 * Peers written in C++ use this too. */
#ifndef BENCH_COMPARE_ANSWERS_H
#define BENCH_COMPARE_ANSWERS_H

#include "bench/measure/worker.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A set of undirected edges: `pairs` holds edge_count times two vertices, in any order. */
void answer_edges(struct worker_answer *answer, const int32_t *pairs, int64_t edge_count);

/* A sum of areas: agrees within 10^-6. */
void answer_area(struct worker_answer *answer, double area);

/* Unit normals, 3 floats each: `count` of vertices or of faces, in any order; agrees within 10^-4
 * on the average. */
void answer_normals(struct worker_answer *answer, const float *normals, int64_t count);

/* Positions, as answer_normals. */
void answer_positions(struct worker_answer *answer, const float *positions, int64_t count);

/* A number that must be the same, and not be 0. */
void answer_count(struct worker_answer *answer, int64_t count);

/* The neighbour (a triangle; < 0: none) across each of a triangle's three sides: side 0 runs from
 * corner 0 to 1. */
void answer_neighbours(struct worker_answer *answer, const int32_t *neighbours,
                       int64_t triangle_count);

/* What strips or an order of triangles are worth: facts `indices` and `cache_misses` (vertices that
 * a first-in-first-out cache of 16 does not hold when they are used). triangles: 3 a triangle, on
 * vertices 0 ... vertex_count - 1. Out of memory leaves the fact out. */
void answer_strips(struct worker_answer *answer, int64_t index_count);
void answer_order(struct worker_answer *answer, int32_t *triangles, int32_t triangle_count,
                  int32_t vertex_count);

/* Whether two programs agree: equal hashes where both have one, equal values where both have one.
 * Returns 1: they agree, 0: they differ, -1: they have nothing that can be compared. */
int answers_agree(const struct worker_answer *left, const struct worker_answer *right);

#ifdef __cplusplus
}
#endif

#endif
