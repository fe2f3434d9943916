/* One step of uniform Laplacian smoothing, fed edge by edge: what every representation that can
 * list its edges shares. */
#ifndef REFERENCE_REPRESENTATION_SMOOTHER_H
#define REFERENCE_REPRESENTATION_SMOOTHER_H

#include "reference/base/error.h"

#include <stdint.h>

struct smoother {
    double *sums;      /* 3 a vertex: sum of its neighbours' positions so far */
    int32_t *valences; /* neighbours so far; negative: the vertex stays where it is */
    int32_t vertex_count;
};

/* Starts a step without any edge; the caller owns it (smoother_release). 28 bytes a vertex. Returns
 * 0, or -1 and *err. */
int smoother_init(struct smoother *smoother, int32_t vertex_count, struct error *err) MUST_CHECK;
void smoother_release(struct smoother *smoother);

/* Makes the vertex stay. */
void smoother_fix(struct smoother *smoother, int32_t vertex);

/* Adds an edge between a and b; give each edge once. */
void smoother_add_edge(struct smoother *smoother, const float *positions, int32_t a, int32_t b);

/* Moves every vertex that has a neighbour, and need not stay, to the mean of its neighbours. */
void smoother_apply(const struct smoother *smoother, float *positions);

#endif
