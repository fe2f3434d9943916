/* Damage for the checks of linked structures: every number of every table is changed in turn. */
#ifndef TESTS_UNIT_DAMAGE_H
#define TESTS_UNIT_DAMAGE_H

#include "reference/mesh/mesh.h"

#include <stdint.h>

struct damage {
    const void *self;
    int (*check)(const void *self, struct error *err);
    uint64_t (*shape_of)(const void *self); /* of a structure that its check accepts */
};

/* Whether another number may be as good: one half edge of a vertex, of several. */
enum choice { NO_CHOICE, SOME_CHOICE };

/* Small meshes, open and closed, with and without isolated vertices. The caller owns them. */
enum { DAMAGE_MESHES = 5 };
struct mesh damage_mesh(int index);

/* Puts wrong values in numbers[0 ... count - 1], one at a time. The check must find each, naming an
 * element; with SOME_CHOICE it may accept a value instead, when the shape stays the same. */
void damage_every_number(const struct damage *damage, const char *table, int32_t *numbers,
                         int64_t count, enum choice choice);

#endif
