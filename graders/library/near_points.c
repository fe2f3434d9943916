/* The nearest of many points; see near_points.h. */
#include "graders/library/near_points.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

static double coordinate(const struct near_points *tree, int32_t point, int axis)
{
    return (double)tree->positions[3 * (int64_t)point + axis];
}

static int widest_axis(const struct near_points *tree, int32_t first, int32_t end)
{
    int widest = 0;
    double most = -1;
    for (int axis = 0; axis < 3; axis++) {
        double low = INFINITY, high = -INFINITY;
        for (int32_t i = first; i < end; i++) {
            double x = coordinate(tree, tree->order[i], axis);
            low = x < low ? x : low;
            high = x > high ? x : high;
        }
        if (high - low > most) {
            most = high - low;
            widest = axis;
        }
    }
    return widest;
}

/* Orders a range so that what stands at `middle` is what would stand there if it were sorted
 * (Hoare's quickselect). */
static void select_middle(struct near_points *tree, int32_t first, int32_t end, int32_t middle,
                          int axis)
{
    int32_t low = first, high = end - 1;
    while (low < high) {
        double pivot = coordinate(tree, tree->order[low + (high - low) / 2], axis);
        int32_t i = low, j = high;
        while (i <= j) {
            while (coordinate(tree, tree->order[i], axis) < pivot)
                i++;
            while (coordinate(tree, tree->order[j], axis) > pivot)
                j--;
            if (i <= j) {
                int32_t point = tree->order[i];
                tree->order[i++] = tree->order[j];
                tree->order[j--] = point;
            }
        }
        if (middle <= j)
            high = j;
        else if (middle >= i)
            low = i;
        else
            return;
    }
}

/* As deep as the logarithm of the count. */
static void split(struct near_points *tree, int32_t first, int32_t end)
{
    while (end - first > 1) {
        int32_t middle = first + (end - first) / 2;
        int axis = widest_axis(tree, first, end);
        select_middle(tree, first, end, middle, axis);
        tree->axis[middle] = (uint8_t)axis;
        split(tree, first, middle);
        first = middle + 1;
    }
}

int near_points_build(struct near_points *tree, const float *positions, int32_t count,
                      struct error *err)
{
    *tree = (struct near_points){.positions = positions, .count = count};
    if (count < 0)
        return error_set(err, "%d points cannot be searched", count);
    tree->order = calloc((size_t)count + 1, sizeof *tree->order);
    tree->axis = calloc((size_t)count + 1, sizeof *tree->axis);
    if (!tree->order || !tree->axis) {
        near_points_release(tree);
        return error_set(err, "out of memory: a tree of %d points", count);
    }
    for (int32_t i = 0; i < count; i++)
        tree->order[i] = i;
    split(tree, 0, count);
    return 0;
}

void near_points_release(struct near_points *tree)
{
    free(tree->order);
    free(tree->axis);
    *tree = (struct near_points){0};
}

struct nearest {
    double p[3];
    double square; /* of the distance of the best one so far, or of the reach */
    int32_t point;
};

static void search(const struct near_points *tree, int32_t first, int32_t end, struct nearest *best)
{
    while (first < end) {
        int32_t middle = first + (end - first) / 2, point = tree->order[middle];
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double d = best->p[axis] - coordinate(tree, point, axis);
            square += d * d;
        }
        bool is_first = best->point < 0 || point < best->point;
        if (square < best->square || (square == best->square && is_first)) {
            best->square = square;
            best->point = point;
        }
        int axis = tree->axis[middle];
        double off = best->p[axis] - coordinate(tree, point, axis);
        bool is_right = off > 0;
        search(tree, is_right ? middle + 1 : first, is_right ? end : middle, best);
        if (!(off * off <= best->square))
            return;
        if (is_right)
            end = middle;
        else
            first = middle + 1;
    }
}

int32_t near_points_find(const struct near_points *tree, const float p[3], double reach)
{
    struct nearest best = {{(double)p[0], (double)p[1], (double)p[2]}, reach * reach, -1};
    bool is_finite = isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]) && reach >= 0;
    if (is_finite)
        search(tree, 0, tree->count, &best);
    return best.point;
}

double near_points_distance(const float p[3], const float q[3])
{
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
        double d = (double)p[axis] - (double)q[axis];
        square += d * d;
    }
    return sqrt(square);
}
