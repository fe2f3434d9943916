/* Exact predicates of points with binary32 coordinates: the sign is right whatever the points are,
 * needles and points of one plane too.
 *
 * A determinant is computed in binary64 first and believed when it is farther from 0 than rounding
 * can take it; else it is added up without rounding, in parts. Any finite coordinates are allowed.
 *
 * Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
 * Predicates (1997): the bounds of the first step and the growing of expansions. */
#ifndef REFERENCE_SURVEY_EXACT_H
#define REFERENCE_SURVEY_EXACT_H

#include <stdbool.h>

/* 1, 0 or -1: d lies on the side of the plane a b c from which the triangle is seen
 * counter-clockwise, on the plane, or on the other side. Also the sign of the volume (b - a) x (c -
 * a) . (d - a). */
int exact_plane_side(const float a[3], const float b[3], const float c[3], const float d[3]);

/* 1, 0 or -1: seen along an axis (0 ... 2, from its positive end), a, b, c run counter-clockwise,
 * lie on a line, or run clockwise. */
int exact_line_side(int axis, const float a[3], const float b[3], const float c[3]);

/* Whether three points lie on a line, or coincide: the triangle has no area. */
bool exact_on_line(const float a[3], const float b[3], const float c[3]);

#endif
