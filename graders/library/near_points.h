/* Finding the nearest of many points: a k-d tree over a table of positions.
 *
 *     struct near_points tree;
 *     if (near_points_build(&tree, positions, vertex_count, err))
 *         return -1;
 *     int32_t v = near_points_find(&tree, p, reach);
 *     near_points_release(&tree);
 */
#ifndef GRADERS_LIBRARY_NEAR_POINTS_H
#define GRADERS_LIBRARY_NEAR_POINTS_H

#include "reference/base/error.h"

#include <stdint.h>

struct near_points {
    const float *positions; /* borrowed */
    int32_t count;
    int32_t *order; /* the tree: the middle of a range splits it */
    uint8_t *axis;  /* of each place in `order`: 0 x, 1 y, 2 z */
};

/* Builds the tree; O(n log n) but for positions made to harm it, so not for an answer's points.
 *
 * positions   3 a point, finite; must outlive the tree
 * returns     0, or -1 and *err (out of memory, negative count) */
int near_points_build(struct near_points *tree, const float *positions, int32_t count,
                      struct error *err) MUST_CHECK;
void near_points_release(struct near_points *tree);

/* The point nearest to p within `reach` (Euclidean, in double), the one with the smallest number of
 * several; -1 when there is none. p may hold anything; with NaN nothing is near. Cost: O(log n)
 * where points are spread; it looks at no more than the tree holds near a ball of radius reach, so
 * keep reach small when asked about an answer's points: all points of a sphere are as near to its
 * centre. */
int32_t near_points_find(const struct near_points *tree, const float p[3], double reach);

/* The distance of two points, in double. */
double near_points_distance(const float p[3], const float q[3]);

#endif
