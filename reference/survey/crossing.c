/* Two triangles in space; see crossing.h. */
#include "reference/survey/crossing.h"

#include "reference/survey/exact.h"

#include <string.h>

static bool same_point(const float *a, const float *b)
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* Sides of the corners p of the plane of q. Common corners lie on it, without being asked. */
static void find_sides(const float *const p[3], const float *const q[3], int sides[3])
{
    for (int i = 0; i < 3; i++)
        sides[i] = same_point(p[i], q[0]) || same_point(p[i], q[1]) || same_point(p[i], q[2])
                       ? 0
                       : exact_plane_side(q[0], q[1], q[2], p[i]);
}

static bool are_on_both_sides(const int sides[3])
{
    bool before = sides[0] > 0 || sides[1] > 0 || sides[2] > 0;
    bool behind = sides[0] < 0 || sides[1] < 0 || sides[2] < 0;
    return before && behind;
}

/* -- in one plane ----------------------------------------------------------------------------- */

/* Whether the line through a side of p has p on the one hand and q on the other. */
static bool has_dividing_side(int axis, const float *const p[3], const float *const q[3])
{
    int turn = exact_line_side(axis, p[0], p[1], p[2]);
    for (int i = 0; i < 3; i++) {
        const float *a = p[i], *b = p[(i + 1) % 3];
        bool divides = true;
        for (int k = 0; divides && k < 3; k++)
            divides = turn * exact_line_side(axis, a, b, q[k]) <= 0;
        if (divides)
            return true;
    }
    return false;
}

static bool overlap_in_plane(const float *const p[3], const float *const q[3])
{
    int axis = 0;
    while (axis < 2 && exact_line_side(axis, p[0], p[1], p[2]) == 0)
        axis++;
    return !has_dividing_side(axis, p, q) && !has_dividing_side(axis, q, p);
}

/* -- in two planes ---------------------------------------------------------------------------- */

/* Turns the triangle until its first corner is the only one on its side of the other's plane.
 * Returns that side. */
static int put_lone_first(const float *p[3], const int sides[3])
{
    int lone = 0, side = 0;
    for (int i = 0; i < 3 && side == 0; i++) {
        int next = sides[(i + 1) % 3], last = sides[(i + 2) % 3];
        if (sides[i] != 0 && next != sides[i] && last != sides[i]) {
            lone = i;
            side = sides[i];
        }
    }
    const float *turned[3] = {p[lone], p[(lone + 1) % 3], p[(lone + 2) % 3]};
    memcpy(p, turned, sizeof turned);
    return side;
}

static void swap_last(const float *p[3])
{
    const float *second = p[1];
    p[1] = p[2];
    p[2] = second;
}

bool triangles_cross(const float *const p[3], const float *const q[3])
{
    int p_sides[3], q_sides[3];
    find_sides(p, q, p_sides);
    if (p_sides[0] == 0 && p_sides[1] == 0 && p_sides[2] == 0)
        return overlap_in_plane(p, q);
    if (!are_on_both_sides(p_sides))
        return false;
    find_sides(q, p, q_sides);
    if (!are_on_both_sides(q_sides))
        return false;
    /* Both cut the line in which the planes meet: the two pieces are compared by their ends. */
    const float *one[3] = {p[0], p[1], p[2]}, *other[3] = {q[0], q[1], q[2]};
    int one_side = put_lone_first(one, p_sides), other_side = put_lone_first(other, q_sides);
    if (one_side < 0)
        swap_last(other);
    if (other_side < 0)
        swap_last(one);
    return exact_plane_side(one[1], other[0], one[0], other[1]) < 0 &&
           exact_plane_side(one[0], other[0], one[2], other[2]) < 0;
}
