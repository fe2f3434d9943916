/* The grid of problems 4.2 and 4.3 as a judge sees it: m rows of n cells on the unit square, every
 * cell cut into two triangles by either diagonal. Vertices are told apart by where they lie, so a
 * student may number vertices and order triangles in any way.
 *
 * Point r * (n + 1) + c of the lattice lies at x = c / n, y = r / m, z = 0. */
#ifndef GRADERS_LIBRARY_LATTICE_H
#define GRADERS_LIBRARY_LATTICE_H

#include "reference/base/error.h"

#include <stdbool.h>
#include <stdint.h>

struct lattice {
    int32_t m, n;
    uint8_t *halves; /* of m * n cells: bit 0 ... 3, the half without that corner is covered */
};

/* m, n >= 1 and m * n <= INT32_MAX. Returns 0, or -1 and *err. Ends with lattice_release. */
int lattice_init(struct lattice *lattice, int32_t m, int32_t n, struct error *err) MUST_CHECK;
void lattice_release(struct lattice *lattice);

/* The lattice point next to a position, -1 when there is none within a quarter of a cell. z is not
 * looked at. */
int32_t lattice_nearest(const struct lattice *lattice, const float position[3]);

/* Whether a position is within `tolerance` of lattice point `point` in each coordinate. */
bool lattice_is_at(const struct lattice *lattice, int32_t point, const float position[3],
                   double tolerance);

/* How a triangle fits, after it was added. Only HALF and HALF_FLIPPED cover anything. */
enum lattice_fit {
    LATTICE_HALF,         /* half a cell, counter-clockwise seen from +z */
    LATTICE_HALF_FLIPPED, /* half a cell, clockwise */
    LATTICE_REPEATED,     /* this half was covered before */
    LATTICE_CROSSED,      /* it overlaps a half that was cut by the other diagonal */
    LATTICE_OUTSIDE       /* not half a cell: its corners are not three corners of one cell */
};

/* Adds a triangle of three lattice points (-1 is allowed: OUTSIDE). *cell gets the number r * n + c
 * of its cell, -1 when it has none. */
enum lattice_fit lattice_add(struct lattice *lattice, int32_t a, int32_t b, int32_t c,
                             int32_t *cell);

/* The first cell that is not covered by two halves, -1 when there is none. */
int32_t lattice_first_uncovered(const struct lattice *lattice);

#endif
