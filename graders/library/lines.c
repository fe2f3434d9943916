/* Point sets, polylines and polygons; see lines.h. */
#include "graders/library/lines.h"

#include "reference/base/random.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEAST_POINTS = 3 };

/* The square in which plane points lie, and whole parts of its side. */
enum { SIDE = 1024, HALF = SIDE / 2, QUARTER = SIDE / 4, EIGHTH = SIDE / 8, FIFTH = SIDE / 5 };

static int32_t dimension_of(enum line_shape shape)
{
    return shape == LINE_HELIX || shape == POINTS_CLUSTERS || shape == POINTS_ON_LINE ? 3 : 2;
}

static bool is_closed(enum line_shape shape)
{
    return shape <= LINE_COLLINEAR;
}

static void set_plane(float *points, int32_t i, double x, double y)
{
    points[2 * i] = (float)round(x);
    points[2 * i + 1] = (float)round(y);
}

static void set_polar(float *points, int32_t i, double angle, double radius)
{
    set_plane(points, i, HALF + radius * cos(angle), HALF + radius * sin(angle));
}

/* Teeth upwards from a bar: two points below, then up and down along the top, from right to left.
 */
static void make_comb(float *points, int32_t count)
{
    set_plane(points, 0, 0, 0);
    set_plane(points, 1, SIDE, 0);
    for (int32_t i = 2; i < count; i++)
        set_plane(points, i, SIDE * (1 - (double)(i - 2) / (count - 3 > 0 ? count - 3 : 1)),
                  i % 2 == 0 ? SIDE : QUARTER);
}

/* Two turns outwards along one arm and back beside it. */
static void make_spiral(float *points, int32_t count)
{
    int32_t half = count / 2;
    for (int32_t i = 0; i < count; i++) {
        bool back = i >= half;
        double part = back ? (double)(count - 1 - i) / (count - half) : (double)i / half;
        double radius = 80 + 380 * part + (back ? -60 : 0);
        set_polar(points, i, 4 * M_PI * part, radius);
    }
}

static void make_square(float *points, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        double along = 4.0 * i / count, part = along - floor(along);
        int side = (int)along;
        double x = side == 0 ? part : side == 1 ? 1 : side == 2 ? 1 - part : 0;
        double y = side == 0 ? 0 : side == 1 ? part : side == 2 ? 1 : 1 - part;
        set_plane(points, i, SIDE * x, SIDE * y);
    }
}

static void make_plane_line(enum line_shape shape, float *points, int32_t count, struct random *rng)
{
    int32_t wide = (int32_t)ceil(sqrt((double)count));
    for (int32_t i = 0; i < count; i++) {
        double angle = 2 * M_PI * i / count;
        int32_t column = i % wide, row = i / wide;
        switch (shape) {
        case LINE_CONVEX:
            set_polar(points, i, angle, HALF);
            break;
        case LINE_STAR:
            set_polar(points, i, angle, i % 2 ? FIFTH : HALF);
            break;
        case LINE_ZIGZAG:
            set_plane(points, i, (double)SIDE * i / count, i % 2 ? QUARTER : HALF);
            break;
        case LINE_PROFILE:
            set_plane(points, i, (double)SIDE * i / count, QUARTER + EIGHTH * sin(angle));
            break;
        case POINTS_GRID:
            set_plane(points, i, (double)column * SIDE / wide, (double)row * SIDE / wide);
            break;
        default: /* x differs for all */
            set_plane(points, i, (double)i * SIDE / count, (double)random_below(rng, SIDE));
        }
    }
}

static void make_space_points(enum line_shape shape, float *points, int32_t count,
                              struct random *rng)
{
    for (int32_t i = 0; i < count; i++) {
        double part = (double)i / count;
        int32_t cluster = i / 4;
        for (int axis = 0; axis < 3; axis++) {
            double place = axis == 0 ? part : 0.5 * part;
            if (shape == LINE_HELIX)
                place = axis == 0 ? 0.5 * cos(12 * part) : axis == 1 ? 0.5 * sin(12 * part) : part;
            if (shape == POINTS_CLUSTERS)
                place = (double)(axis == 0   ? cluster % 16
                                 : axis == 1 ? cluster / 16 % 16
                                             : cluster / 256) /
                            16 +
                        1e-4 * random_real(rng);
            points[3 * i + axis] = (float)place;
        }
    }
}

static void reverse(float *points, int32_t count, int32_t dimension)
{
    for (int32_t i = 0, j = count - 1; i < j; i++, j--)
        for (int32_t axis = 0; axis < dimension; axis++) {
            float kept = points[i * dimension + axis];
            points[i * dimension + axis] = points[j * dimension + axis];
            points[j * dimension + axis] = kept;
        }
}

/* Another start of a closed line, another order of points; other lines stay as they are. */
static int scramble(enum line_shape shape, float *points, int32_t count, int32_t dimension,
                    struct random *rng, struct error *err)
{
    size_t bytes = sizeof *points * (size_t)(count * dimension);
    int32_t *order = malloc(sizeof *order * (size_t)count);
    float *copy = malloc(bytes);
    int failed = order && copy ? 0 : error_set(err, "out of memory for %d points", count);
    if (!failed) {
        int32_t turn = (int32_t)random_below(rng, (uint64_t)count);
        memcpy(copy, points, bytes);
        random_permutation(rng, order, count);
        for (int32_t i = 0; i < count; i++) {
            int32_t from = is_closed(shape)         ? (i + turn) % count
                           : shape >= POINTS_RANDOM ? order[i]
                                                    : i;
            memcpy(points + i * dimension, copy + from * dimension,
                   sizeof *points * (size_t)dimension);
        }
    }
    free(order);
    free(copy);
    return failed;
}

static void make_points(enum line_shape shape, float *points, int32_t count, struct random *rng)
{
    if (dimension_of(shape) == 3)
        make_space_points(shape, points, count, rng);
    else if (shape == LINE_COMB)
        make_comb(points, count);
    else if (shape == LINE_SPIRAL)
        make_spiral(points, count);
    else if (shape == LINE_COLLINEAR)
        make_square(points, count);
    else
        make_plane_line(shape, points, count, rng);
}

int line_write(const struct line_recipe *recipe, uint64_t seed, struct writer *input,
               struct error *err)
{
    int32_t count = recipe->count, dimension = dimension_of(recipe->shape);
    if (count < 0 || (is_closed(recipe->shape) && count < LEAST_POINTS))
        return error_set(err, "%d points are too few for this shape", count);
    float *points = calloc((size_t)(count * dimension) + 1, sizeof *points);
    if (!points)
        return error_set(err, "out of memory for %d points", count);
    struct random rng;
    random_init(&rng, seed);
    make_points(recipe->shape, points, count, &rng);
    if (recipe->reversed)
        reverse(points, count, dimension);
    int failed = recipe->scrambled && count > 0
                     ? scramble(recipe->shape, points, count, dimension, &rng, err)
                     : 0;
    write_int(input, count);
    write_int(input, is_closed(recipe->shape));
    write_int(input, dimension);
    write_array(input, points, count * dimension, sizeof *points);
    free(points);
    if (!failed && input->failed)
        failed = error_set(err, "out of memory for an input");
    return failed;
}

struct line_view line_read(struct reader *input)
{
    struct line_view view = {0};
    view.point_count = (int32_t)read_int(input);
    view.is_closed = read_int(input) != 0;
    view.dimension = (int32_t)read_int(input);
    view.points = read_array(input, (int64_t)view.point_count * view.dimension, sizeof(float));
    return view;
}
