/* Boundary sides chained into closed loops. */
#ifndef REFERENCE_REPRESENTATION_BOUNDARY_CHAIN_H
#define REFERENCE_REPRESENTATION_BOUNDARY_CHAIN_H

#include "reference/base/error.h"

#include <stdint.h>

/* Walks along unused sides, forwards where there is a choice, until it is back; then from the next
 * unused side. Coherent sides are all walked forwards.
 *
 * sides        2 * side_count vertices: from, to
 * vertices     room for side_count; loop_starts: room for side_count + 1
 * returns      number of loops; -1 and *err when the sides do not close, naming a vertex, or memory
 *              runs out
 * cost         linear in sides and vertices; 4 bytes a vertex and 9 a side meanwhile */
int32_t boundary_chain(const int32_t *sides, int64_t side_count, int32_t vertex_count,
                       int32_t *vertices, int32_t *loop_starts, struct error *err);

#endif
