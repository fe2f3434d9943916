/* Height fields and volumes; see fields.h. */
#include "graders/library/fields.h"

#include "reference/base/random.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

static double height_at(enum field_shape shape, double x, double y)
{
    switch (shape) {
    case FIELD_RAMP:
        return 0.5 * x + 0.25 * y;
    case FIELD_WAVES:
        return 0.1 * sin(6 * x) + 0.1 * cos(7 * y);
    case FIELD_STEPS:
        return floor(4 * x) * 0.125 + floor(3 * y) * 0.0625;
    case FIELD_PEAK:
        return 0.5 * exp(-20 * ((x - 0.4) * (x - 0.4) + (y - 0.6) * (y - 0.6)));
    default:
        return 0;
    }
}

static double sphere(double x, double y, double z, double cx, double radius)
{
    return sqrt((x - cx) * (x - cx) + (y - 0.5) * (y - 0.5) + (z - 0.5) * (z - 0.5)) - radius;
}

static double distance_at(enum field_shape shape, double x, double y, double z)
{
    double dx = fabs(x - 0.5) - 0.3, dy = fabs(y - 0.5) - 0.2, dz = fabs(z - 0.5) - 0.25;
    double ring = sqrt((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5)) - 0.28;
    switch (shape) {
    case FIELD_SPHERE:
        return sphere(x, y, z, 0.5, 0.35);
    case FIELD_TWO_SPHERES:
        return fmin(sphere(x, y, z, 0.25, 0.18), sphere(x, y, z, 0.75, 0.18));
    case FIELD_BOX:
        return fmax(dx, fmax(dy, dz));
    case FIELD_TORUS:
        return sqrt(ring * ring + (z - 0.5) * (z - 0.5)) - 0.13;
    default:
        return 1;
    }
}

static bool is_volume(enum field_shape shape)
{
    return shape >= FIELD_SPHERE && shape != FIELD_NOISE;
}

/* The place of sample i of `count` along one side. */
static double along(int32_t i, int32_t count)
{
    return count > 1 ? (double)i / (double)(count - 1) : 0;
}

int field_write(const struct field_recipe *recipe, uint64_t seed, struct writer *input,
                struct error *err)
{
    int64_t layers = recipe->layers > 0 ? recipe->layers : 1;
    int64_t count = (int64_t)recipe->rows * recipe->columns * layers;
    if (count <= 0 || (is_volume(recipe->shape) && recipe->layers <= 0))
        return error_set(err, "a field of %d x %d x %d samples has no such shape", recipe->columns,
                         recipe->rows, recipe->layers);
    float *samples = malloc(sizeof *samples * (size_t)count);
    if (!samples)
        return error_set(err, "out of memory for %lld samples", (long long)count);
    struct random rng;
    random_init(&rng, seed);
    int64_t i = 0;
    for (int32_t l = 0; l < layers; l++)
        for (int32_t r = 0; r < recipe->rows; r++)
            for (int32_t c = 0; c < recipe->columns; c++) {
                double x = along(c, recipe->columns), y = along(r, recipe->rows);
                samples[i++] = recipe->shape == FIELD_NOISE ? random_float(&rng, -0.5F, 0.5F)
                               : recipe->layers > 0 ? (float)distance_at(recipe->shape, x, y,
                                                                         along(l, recipe->layers))
                                                    : (float)height_at(recipe->shape, x, y);
            }
    write_int(input, recipe->rows);
    write_int(input, recipe->columns);
    write_int(input, recipe->layers);
    write_array(input, samples, count, sizeof *samples);
    free(samples);
    return input->failed ? error_set(err, "out of memory for an input") : 0;
}

struct field_view field_read(struct reader *input)
{
    struct field_view view = {0};
    view.rows = (int32_t)read_int(input);
    view.columns = (int32_t)read_int(input);
    view.layers = (int32_t)read_int(input);
    view.sample_count = (int64_t)view.rows * view.columns * (view.layers > 0 ? view.layers : 1);
    view.samples = read_array(input, view.sample_count, sizeof *view.samples);
    return view;
}
