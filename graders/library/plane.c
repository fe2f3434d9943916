/* Exact predicates of the plane; see plane.h. */
#include "graders/library/plane.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

/* Differences have 31 bits with their sign, products 61, sums of two 62. */
int64_t plane_twice_area(struct plane_point a, struct plane_point b, struct plane_point c)
{
    int64_t bx = (int64_t)b.x - a.x, by = (int64_t)b.y - a.y;
    int64_t cx = (int64_t)c.x - a.x, cy = (int64_t)c.y - a.y;
    return bx * cy - by * cx;
}

int plane_side(struct plane_point a, struct plane_point b, struct plane_point c)
{
    int64_t area = plane_twice_area(a, b, c);
    return (area > 0) - (area < 0);
}

__extension__ typedef __int128 wide;

int plane_in_circle(struct plane_point a, struct plane_point b, struct plane_point c,
                    struct plane_point d)
{
    int64_t ax = (int64_t)a.x - d.x, ay = (int64_t)a.y - d.y;
    int64_t bx = (int64_t)b.x - d.x, by = (int64_t)b.y - d.y;
    int64_t cx = (int64_t)c.x - d.x, cy = (int64_t)c.y - d.y;
    wide sum = (wide)(ax * ax + ay * ay) * (bx * cy - by * cx) +
               (wide)(bx * bx + by * by) * (cx * ay - cy * ax) +
               (wide)(cx * cx + cy * cy) * (ax * by - ay * bx);
    return (sum > 0) - (sum < 0);
}

bool plane_is_between(struct plane_point a, struct plane_point b, struct plane_point p)
{
    if (plane_twice_area(a, b, p) != 0)
        return false;
    int64_t ax = (int64_t)a.x - p.x, ay = (int64_t)a.y - p.y;
    int64_t bx = (int64_t)b.x - p.x, by = (int64_t)b.y - p.y;
    return ax * bx + ay * by < 0;
}

/* The exponent of the last bit of a number that is not 0. */
static int last_bit(float x)
{
    int exponent;
    long mantissa = labs((long)ldexpf(frexpf(x, &exponent), 24));
    return exponent - 24 + __builtin_ctzl((unsigned long)mantissa);
}

bool plane_points_of_floats(const float *xy, int stride, int64_t count, struct plane_point *points)
{
    int finest = INT_MAX, largest = INT_MIN;
    for (int64_t i = 0; i < count; i++)
        for (int axis = 0; axis < 2; axis++) {
            float x = xy[stride * i + axis];
            int exponent;
            if (!isfinite(x))
                return false;
            if (x == 0)
                continue;
            frexpf(x, &exponent);
            finest = last_bit(x) < finest ? last_bit(x) : finest;
            largest = exponent > largest ? exponent : largest;
        }
    if (finest < INT_MAX && largest - finest > 29)
        return false;
    for (int64_t i = 0; i < count; i++) {
        double x = (double)xy[stride * i], y = (double)xy[stride * i + 1];
        int shift = finest < INT_MAX ? -finest : 0;
        points[i] = (struct plane_point){(int32_t)ldexp(x, shift), (int32_t)ldexp(y, shift)};
    }
    return true;
}
