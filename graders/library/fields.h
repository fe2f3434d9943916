/* Sampled inputs: height fields and volumes.
 *
 *     {.field = {FIELD_WAVES, .rows = 9, .columns = 17}}            a height field
 *     {.field = {FIELD_TORUS, .rows = 16, .columns = 16, .layers = 16}}   a volume
 *
 * Packet: int rows, int columns, int layers (0: a height field), float samples[rows * columns], or
 * [rows * columns * layers]; sample (c, r, l) is number c + columns * (r + rows * l) and lies at
 * the place c / (columns - 1), r / (rows - 1), l / (layers - 1) of the unit cube (a lone row at 0).
 */
#ifndef GRADERS_LIBRARY_FIELDS_H
#define GRADERS_LIBRARY_FIELDS_H

#include "graders/wire/packet.h"
#include "reference/base/error.h"

enum field_shape {
    /* heights */
    FIELD_FLAT,
    FIELD_RAMP,
    FIELD_WAVES,
    FIELD_STEPS, /* terraces: equal heights and sudden ones */
    FIELD_PEAK,
    /* volumes: distances to a surface, below zero inside */
    FIELD_SPHERE,
    FIELD_TWO_SPHERES, /* apart */
    FIELD_BOX,
    FIELD_TORUS,
    FIELD_OUTSIDE, /* above zero everywhere */
    FIELD_NOISE    /* heights or distances at random: every configuration of a cell */
};

struct field_recipe {
    enum field_shape shape;
    int32_t rows, columns, layers;
};

/* Makes a field and writes it. Returns 0, or -1 and *err (out of memory, no samples, a volume's
 * shape without layers). */
int field_write(const struct field_recipe *recipe, uint64_t seed, struct writer *input,
                struct error *err) MUST_CHECK;

/* A field in a packet, in place. */
struct field_view {
    int32_t rows, columns, layers;
    const float *samples;
    int64_t sample_count;
};
struct field_view field_read(struct reader *input);

#endif
