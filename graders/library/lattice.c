/* The grid of problems 4.2 and 4.3; see lattice.h. */
#include "graders/library/lattice.h"

#include <math.h>
#include <stdlib.h>

int lattice_init(struct lattice *lattice, int32_t m, int32_t n, struct error *err)
{
    *lattice = (struct lattice){.m = m, .n = n};
    lattice->halves = calloc((size_t)m * (size_t)n, 1);
    if (!lattice->halves)
        return error_set(err, "out of memory for a grid of %d rows of %d cells", m, n);
    return 0;
}

void lattice_release(struct lattice *lattice)
{
    free(lattice->halves);
    *lattice = (struct lattice){0};
}

/* The whole number next to `at` when it is within a quarter and in 0 ... last, else -1. */
static int32_t nearest_step(double at, int32_t last)
{
    if (!(at >= -0.25 && at <= last + 0.25))
        return -1;
    double step = round(at);
    return fabs(at - step) <= 0.25 ? (int32_t)step : -1;
}

int32_t lattice_nearest(const struct lattice *lattice, const float position[3])
{
    int32_t column = nearest_step((double)position[0] * lattice->n, lattice->n);
    int32_t row = nearest_step((double)position[1] * lattice->m, lattice->m);
    return column < 0 || row < 0 ? -1 : row * (lattice->n + 1) + column;
}

bool lattice_is_at(const struct lattice *lattice, int32_t point, const float position[3],
                   double tolerance)
{
    int32_t row = point / (lattice->n + 1);
    int32_t column = point % (lattice->n + 1);
    double x = (double)column / lattice->n;
    double y = (double)row / lattice->m;
    return fabs((double)position[0] - x) <= tolerance &&
           fabs((double)position[1] - y) <= tolerance && fabs((double)position[2]) <= tolerance;
}

static int32_t smallest(int32_t a, int32_t b, int32_t c)
{
    int32_t least = a < b ? a : b;
    return least < c ? least : c;
}

enum lattice_fit lattice_add(struct lattice *lattice, int32_t a, int32_t b, int32_t c,
                             int32_t *cell)
{
    *cell = -1;
    if (a < 0 || b < 0 || c < 0)
        return LATTICE_OUTSIDE;
    const int32_t point[3] = {a, b, c};
    int32_t row[3], column[3];
    for (int i = 0; i < 3; i++) {
        row[i] = point[i] / (lattice->n + 1);
        column[i] = point[i] % (lattice->n + 1);
    }
    int32_t first_row = smallest(row[0], row[1], row[2]);
    int32_t first_column = smallest(column[0], column[1], column[2]);
    unsigned corners = 0;
    for (int i = 0; i < 3; i++) {
        int32_t down = row[i] - first_row, along = column[i] - first_column;
        if (down > 1 || along > 1)
            return LATTICE_OUTSIDE;
        corners |= 1u << (2 * down + along);
    }
    unsigned missing = ~corners & 15u;
    if (missing == 0 || (missing & (missing - 1)) != 0) /* not just one corner of four */
        return LATTICE_OUTSIDE;
    *cell = first_row * lattice->n + first_column;
    uint8_t *halves = &lattice->halves[*cell];
    unsigned other_diagonal = missing == 1u || missing == 8u ? 6u : 9u;
    if (*halves & missing)
        return LATTICE_REPEATED;
    if (*halves & other_diagonal)
        return LATTICE_CROSSED;
    *halves |= (uint8_t)missing;
    int32_t turn =
        (column[1] - column[0]) * (row[2] - row[0]) - (column[2] - column[0]) * (row[1] - row[0]);
    return turn > 0 ? LATTICE_HALF : LATTICE_HALF_FLIPPED;
}

int32_t lattice_first_uncovered(const struct lattice *lattice)
{
    int64_t cell_count = (int64_t)lattice->m * lattice->n;
    for (int64_t cell = 0; cell < cell_count; cell++)
        if (lattice->halves[cell] != 6u && lattice->halves[cell] != 9u)
            return (int32_t)cell;
    return -1;
}
