/* The distance of two surfaces; see distance.h. The tree: triangle_tree.c. */
#include "graders/library/distance.h"

#include <inttypes.h>
#include <math.h>

/* What a point must be farther by than the farthest so far, to be looked at to the end. */
static const double ENOUGH = 1.001;

static void corners_of(const struct surface_mesh *mesh, int64_t triangle, double corner[3][3])
{
    for (int c = 0; c < 3; c++)
        for (int axis = 0; axis < 3; axis++)
            corner[c][axis] =
                (double)mesh->positions[3 * (int64_t)mesh->triangles[3 * triangle + c] + axis];
}

/* The points of a triangle: its corners, then the middles of ten equal parts, as the points of a
 * lattice of side 3, drawn in by a third of a step. */
static void sample(double corner[3][3], int number, double p[3])
{
    double weight[3] = {0, 0, 0};
    if (number < 3) {
        weight[number] = 1;
    } else {
        int row = 0, place = number - 3;
        while (place > row)
            place -= ++row;
        weight[0] = (3 - row + 1.0 / 3) / 4;
        weight[1] = (place + 1.0 / 3) / 4;
        weight[2] = (row - place + 1.0 / 3) / 4;
    }
    for (int axis = 0; axis < 3; axis++)
        p[axis] =
            weight[0] * corner[0][axis] + weight[1] * corner[1][axis] + weight[2] * corner[2][axis];
}

/* Looks at the points of one surface, in the order of its tree. */
static struct surface_farthest find_farthest(const struct triangle_tree *from,
                                             const struct triangle_tree *to)
{
    struct surface_farthest farthest = {.distance = 0, .triangle = -1, .nearest = -1};
    int32_t nearest = -1; /* to the point before, which lies beside */
    for (int32_t i = 0; i < from->count; i++) {
        double corner[3][3];
        corners_of(from->mesh, from->order[i], corner);
        for (int number = 0; number < 3 + SURFACE_SAMPLES; number++) {
            double p[3];
            sample(corner, number, p);
            double enough = ENOUGH * farthest.distance;
            double distance = triangle_tree_distance(to, p, enough, &nearest);
            if (farthest.triangle >= 0 && !(distance > enough)) /* nor need it be exact */
                continue;
            farthest =
                (struct surface_farthest){distance, {p[0], p[1], p[2]}, from->order[i], nearest};
        }
    }
    return farthest;
}

/* A box around a surface. */
static void box_of(const struct surface_mesh *mesh, double low[3], double high[3])
{
    for (int axis = 0; axis < 3; axis++) {
        low[axis] = INFINITY;
        high[axis] = -INFINITY;
        for (int32_t v = 0; v < mesh->vertex_count; v++) {
            double x = (double)mesh->positions[3 * (int64_t)v + axis];
            low[axis] = x < low[axis] ? x : low[axis];
            high[axis] = x > high[axis] ? x : high[axis];
        }
        if (!(low[axis] <= high[axis]))
            low[axis] = high[axis] = 0;
    }
}

int surface_distance_find(const struct surface_mesh *answer, const struct surface_mesh *right,
                          struct surface_distance *distance, struct error *err)
{
    struct triangle_tree of_answer, of_right;
    double low[3], high[3];
    *distance = (struct surface_distance){.bad_corner = -1};
    box_of(right, low, high);
    if (triangle_tree_build(&of_right, right, low, high, err))
        return -1;
    if (of_right.bad_corner_count > 0) {
        triangle_tree_release(&of_right);
        return error_set(err, "the right surface has a corner that is no finite vertex");
    }
    if (triangle_tree_build(&of_answer, answer, low, high, err)) {
        triangle_tree_release(&of_right);
        return -1;
    }
    distance->bad_corner = of_answer.bad_corner;
    distance->bad_corner_count = of_answer.bad_corner_count;
    distance->from_answer = find_farthest(&of_answer, &of_right);
    distance->from_right = find_farthest(&of_right, &of_answer);
    distance->hausdorff = fmax(distance->from_answer.distance, distance->from_right.distance);
    if (distance->bad_corner_count > 0)
        distance->hausdorff = INFINITY;
    triangle_tree_release(&of_answer);
    triangle_tree_release(&of_right);
    return 0;
}
