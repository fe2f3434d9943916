/* Whether two triangles in space run through each other. */
#ifndef REFERENCE_SURVEY_CROSSING_H
#define REFERENCE_SURVEY_CROSSING_H

#include <stdbool.h>

/* Whether the insides of two triangles have a point in common; exact (exact.h). What only touches
 * does not cross: a common corner or side, a corner on a face or a side of the other. Triangles of
 * one plane cross when they overlap, the same triangle twice does.
 *
 * p, q   three corners each; neither is flat (exact_on_line)
 *
 * Source: Guigue and Devillers, Fast and Robust Triangle-Triangle Overlap Test Using Orientation
 * Predicates (2003), with strict signs */
bool triangles_cross(const float *const p[3], const float *const q[3]);

#endif
