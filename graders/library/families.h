/* Families of meshes of any size: what growth, work and memory are measured on.
 *
 *     static const struct size_family families[] = {
 *         {"sphere-scrambled", FAMILY_SPHERE, SCRAMBLED},
 *         {"grid-scrambled-flipped", FAMILY_GRID, FLIPPED | SCRAMBLED},
 *         {NULL}};
 *
 * The size is exact: n triangles (closed meshes have an even number: for an odd n one less). All
 * valences are bounded but where the family says otherwise. */
#ifndef GRADERS_LIBRARY_FAMILIES_H
#define GRADERS_LIBRARY_FAMILIES_H

#include "graders/library/recipe.h"

#include <stdbool.h>

enum family_shape {
    FAMILY_OWN,       /* the judge makes it itself (struct judge, make_sized) */
    FAMILY_SPHERE,    /* closed, 8 meridians */
    FAMILY_GRID,      /* open, 8 columns */
    FAMILY_TORUS,     /* closed, one handle */
    FAMILY_STRIP,     /* open, one row: half of all sides are boundary, one loop */
    FAMILY_WINDOWS,   /* a grid with a hole in every sixteenth triangle, many loops */
    FAMILY_SEPARATE,  /* triangles apart: a component and a loop each */
    FAMILY_FAN,       /* one apex of valence n */
    FAMILY_BIPYRAMID, /* two apexes of valence n / 2, closed */
    FAMILY_QUADS      /* closed, of quads: for exercises that take polygons; n is the corner */
};

struct size_family {
    const char *name; /* unique in the exercise; NULL ends a list */
    enum family_shape shape;
    uint32_t changes; /* enum mesh_change: FLIPPED, REVERSED, SCRAMBLED, ADVERSARIAL */
    bool is_query;    /* of an exercise that builds and is asked: measures the queries */
    bool has_number;  /* of an exercise that gets numbers beside the mesh: these */
    int64_t number[4];
};

enum { FAMILY_LEAST = 16 }; /* the smallest size that every family has */

/* Makes the mesh of a size (all shapes but FAMILY_OWN and FAMILY_QUADS).
 *
 * mesh      on success the caller owns it
 * returns   0, or -1 and *err (out of memory, too small a size) */
int family_make(const struct size_family *family, int64_t triangle_count, uint64_t seed,
                struct mesh *mesh, struct error *err) MUST_CHECK;

#endif
