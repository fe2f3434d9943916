/* Exact predicates of points of the plane: no rounding, whatever the points.
 *
 * Coordinates are whole numbers. Those of binary32 become whole when multiplied by a power of two
 * (plane_points_of_floats), and the predicates do not change by that. */
#ifndef GRADERS_LIBRARY_PLANE_H
#define GRADERS_LIBRARY_PLANE_H

#include <stdbool.h>
#include <stdint.h>

enum { PLANE_COORDINATE_MOST = 1 << 29 }; /* in absolute value */

struct plane_point {
    int32_t x, y;
};

/* Twice the signed area of a triangle: positive when it runs counter-clockwise. */
int64_t plane_twice_area(struct plane_point a, struct plane_point b, struct plane_point c);

/* 1, 0 or -1: c lies to the left of a -> b, on that line, or to the right. */
int plane_side(struct plane_point a, struct plane_point b, struct plane_point c);

/* 1, 0 or -1: d lies inside, on or outside the circle through a, b, c (counter-clockwise; the other
 * way round the sign turns; 0 for points of a line and d on it). */
int plane_in_circle(struct plane_point a, struct plane_point b, struct plane_point c,
                    struct plane_point d);

/* Whether p lies on the segment a b but at neither end. */
bool plane_is_between(struct plane_point a, struct plane_point b, struct plane_point p);

/* Makes points of binary32 coordinates by multiplying all by one power of two.
 *
 * xy        x and y of point i are xy[stride * i] and xy[stride * i + 1]
 * returns   false when they are not exact so: NaN, infinity, or more than 29 bits from the largest
 *           coordinate to the last bit of the finest. Integers up to 1024 and multiples of 2^-18 up
 *           to 1024 always are */
bool plane_points_of_floats(const float *xy, int stride, int64_t count, struct plane_point *points);

#endif
