/* Recipes of meshes: a shape by its name and parameters, and what is done to it.
 *
 *     {.shape = SHAPE_TORUS, .genus = 2, .triangles = 2400, .changes = SCRAMBLED | HIGH_NUMBERS}
 *
 * A case of an exercise that takes a triangle mesh names a recipe (judge.h); polygons.h makes
 * meshes of polygons from the same recipes. Same recipe and seed, same mesh. */
#ifndef GRADERS_LIBRARY_RECIPE_H
#define GRADERS_LIBRARY_RECIPE_H

#include "reference/mesh/mesh.h"

/* Behind each shape stand the fields of a recipe that it reads. */
enum mesh_shape {
    SHAPE_EMPTY,
    SHAPE_ONE_TRIANGLE,
    SHAPE_TETRAHEDRON,
    SHAPE_CUBE,
    SHAPE_GRID,            /* rows, columns */
    SHAPE_UV_SPHERE,       /* meridians, parallels */
    SHAPE_ICO,             /* levels */
    SHAPE_TORUS,           /* genus, triangles (about) */
    SHAPE_DISC,            /* rings, sectors */
    SHAPE_ANNULUS,         /* sectors; one ring of quads: two boundary loops */
    SHAPE_FAN,             /* count: triangles */
    SHAPE_BIPYRAMID,       /* count: valence of the two apexes */
    SHAPE_MOEBIUS,         /* count: quads */
    SHAPE_TWO_CONES,       /* count: sectors; they share their apex */
    SHAPE_TWO_CUBES,       /* which share an edge */
    SHAPE_BOOK,            /* count: triangles on one edge */
    SHAPE_ROUND_AN_EDGE,   /* count: closed tetrahedra that all share one edge */
    SHAPE_BOW_TIE,         /* count: fans of two triangles that share one vertex */
    SHAPE_SEPARATE,        /* count: triangles, no two of which share a vertex */
    SHAPE_NEEDLES,         /* count, exponent: as high as the base / 10^exponent */
    SHAPE_ISOLATED,        /* count: vertices, and no triangle */
    SHAPE_POINT_TRIANGLES, /* count: triangles (v,v,v) on as many vertices */
    SHAPE_BUNNY,           /* models that come with the project: open, two boundary loops */
    SHAPE_HORSE,           /* closed, no handle */
    SHAPE_MUG,             /* closed, one handle */
    /* of polygons: only for exercises that take these (polygons.h) */
    SHAPE_QUAD_CUBE,
    SHAPE_QUAD_GRID,    /* rows, columns */
    SHAPE_QUAD_TORUS,   /* rows, columns */
    SHAPE_PRISM,        /* count: corners of its two large faces */
    SHAPE_COURSE_PRISM, /* the prism of the course's table: two triangles, three quads */
    SHAPE_POLYGON       /* count: corners; one face */
};

/* What is done to the shape, in this order. Numbers of elements are a fraction of the mesh's, at
 * least one. */
enum mesh_change {
    WITH_HOLES = 1 << 0,      /* 1/16 of the faces removed, wherever they are */
    WITH_WINDOWS = 1 << 1,    /* as many, no two of which share a vertex, none at the boundary */
    WITH_COMPONENTS = 1 << 2, /* a tetrahedron, a cube and an icosphere (prism) appended */
    WITH_ISOLATED = 1 << 3,   /* a quarter more vertices */
    WITH_DUPLICATES = 1 << 4, /* 1/8 of the triangles listed twice */
    WITH_DEGENERATE = 1 << 5, /* 1/8 more, on edges that are there already */
    WITH_COLLINEAR = 1 << 6,  /* 1/8 more (a,m,b), m a new vertex halfway from a to b */
    WITH_SPIKES = 1 << 7,     /* 1/8 more (a,a,b), each with an edge of its own */
    FLIPPED = 1 << 8,         /* each face reversed with probability 1/2 */
    REVERSED = 1 << 9,
    TILTED = 1 << 10,    /* turned by 1 radian around (1,2,3), so that no side lies along an axis */
    TINY = 1 << 11,      /* scaled by 2^-40, about 10^-12 */
    HUGE_SIZE = 1 << 12, /* scaled by 2^40 */
    FAR = 1 << 13,       /* scaled by 32 and moved by (10^6, -10^6, 10^6) */
    SCRAMBLED = 1 << 14, /* vertices renumbered, faces permuted, corners rotated at random */
    ADVERSARIAL = 1 << 15,
    HIGH_NUMBERS = 1 << 16, /* 66,000 unused vertices before all others: 16 bits overflow, and
                               i * vertex_count + j in 32 bits */
    VAST_NUMBERS =
        1 << 17 /* 2^21 + 1,000 unused vertices before all others, without positions: keys
                               of 20 bits overflow, and i * 2^32 + j in a double loses its last bit */
};

struct mesh_recipe {
    enum mesh_shape shape;
    int32_t rows, columns;
    int32_t meridians, parallels;
    int32_t levels;
    int32_t genus, triangles;
    int32_t rings, sectors;
    int32_t count, exponent;
    uint32_t changes; /* enum mesh_change */
};

/* Makes the triangle mesh of a recipe.
 *
 * seed      decides everything that is random
 * models    folder with the models; may be NULL when the shape is none of them
 * mesh      on success the caller owns it
 * returns   0, or -1 and *err (out of memory, a parameter that its shape cannot have, a shape of
 *           polygons) */
int recipe_make(const struct mesh_recipe *recipe, uint64_t seed, const char *models,
                struct mesh *mesh, struct error *err) MUST_CHECK;

/* Does FLIPPED, REVERSED, SCRAMBLED and ADVERSARIAL of `changes` to a mesh. Returns 0, or -1 and
 * *err. */
int recipe_change_order(struct mesh *mesh, uint32_t changes, uint64_t seed,
                        struct error *err) MUST_CHECK;

/* Vertices that a recipe puts before all others, and which no face uses. */
int32_t recipe_unused_vertices(const struct mesh_recipe *recipe);

#endif
