/* Standard cases of triangle meshes, class by class: each class is pure, so that a mistake shows in
 * the class that is named after it. A judge puts the classes that its exercise has into its table
 * and adds its own:
 *
 *     static const struct judge_case cases[] = {
 *         CASES_CLOSED(1), CASES_OPEN(11), CASES_SEVERAL_COMPONENTS(31), CASES_EMPTY(101),
 *         {"annulus", "annulus", 120, PUBLIC | QUICK, .mesh = {SHAPE_ANNULUS, .sectors = 9}},
 *     };
 *
 * The number is the first seed; ten seeds from there on belong to the class. Meshes are closed but
 * in `open` (and the Moebius strip), coherent but in `incoherent-orientation`, in one component but
 * in `several-components`, and so on; only `high-valence` has vertices with more than 32
 * neighbours, only `high-numbers` has numbers that overflow 16 bits, 32 bits when multiplied, or,
 * where the mesh is vast, 20 bits or the mantissa of a double that holds two. */
#ifndef GRADERS_LIBRARY_CASES_H
#define GRADERS_LIBRARY_CASES_H

#include "graders/library/judge.h"

#define CASES_CLOSED(seed)                                                                         \
    {"tetrahedron", "closed", (seed), PUBLIC | QUICK, .mesh = {SHAPE_TETRAHEDRON}},                \
        {"cube", "closed", (seed) + 1, QUICK, .mesh = {SHAPE_CUBE, .changes = SCRAMBLED}},         \
        {"sphere", "closed", (seed) + 2, PUBLIC,                                                   \
         .mesh = {SHAPE_UV_SPHERE, .meridians = 24, .parallels = 20}},                             \
        {"icosphere-scrambled", "closed", (seed) + 3, QUICK,                                       \
         .mesh = {SHAPE_ICO, .levels = 3, .changes = SCRAMBLED}},                                  \
    {                                                                                              \
        "horse", "closed", (seed) + 7, HIDDEN, .mesh = { SHAPE_HORSE, .changes = SCRAMBLED }       \
    }

/* Bodies with handles: more than 3 (V - 2) edges. Of any class. */
#define CASES_GENUS_AS(class, seed)                                                                \
    {"torus", (class), (seed), PUBLIC | QUICK,                                                     \
     .mesh = {SHAPE_TORUS, .genus = 1, .triangles = 600}},                                         \
        {"torus-adversarial", (class), (seed) + 1, HIDDEN,                                         \
         .mesh = {SHAPE_TORUS, .genus = 1, .triangles = 1200, .changes = ADVERSARIAL}},            \
        {"torus-genus-2", (class), (seed) + 2, QUICK,                                              \
         .mesh = {SHAPE_TORUS, .genus = 2, .triangles = 2400, .changes = SCRAMBLED}},              \
        {"torus-genus-3", (class), (seed) + 3, HIDDEN,                                             \
         .mesh = {SHAPE_TORUS, .genus = 3, .triangles = 2400, .changes = SCRAMBLED}},              \
    {                                                                                              \
        "mug", (class), (seed) + 4, HIDDEN, .mesh = { SHAPE_MUG }                                  \
    }
#define CASES_GENUS(seed) CASES_GENUS_AS("genus", seed)

#define CASES_OPEN(seed)                                                                           \
    {"one-triangle", "open", (seed), PUBLIC | QUICK, .mesh = {SHAPE_ONE_TRIANGLE}},                \
        {"grid", "open", (seed) + 1, PUBLIC | QUICK,                                               \
         .mesh = {SHAPE_GRID, .rows = 4, .columns = 8}},                                           \
        {"grid-scrambled", "open", (seed) + 2, QUICK,                                              \
         .mesh = {SHAPE_GRID, .rows = 24, .columns = 31, .changes = SCRAMBLED}},                   \
        {"disc-scrambled", "open", (seed) + 3, HIDDEN,                                             \
         .mesh = {SHAPE_DISC, .rings = 8, .sectors = 12, .changes = SCRAMBLED}},                   \
        {"fan", "open", (seed) + 4, HIDDEN,                                                        \
         .mesh = {SHAPE_FAN, .count = 9, .changes = SCRAMBLED}},                                   \
    {                                                                                              \
        "bunny", "open", (seed) + 6, QUICK, .mesh = { SHAPE_BUNNY, .changes = SCRAMBLED }          \
    }

/* Holes wherever they fall: vertices at which several fans meet are among them. */
#define CASES_OPEN_HOLES(seed)                                                                     \
    {                                                                                              \
        "sphere-with-holes", "open", (seed), HIDDEN, .mesh = {                                     \
            SHAPE_ICO,                                                                             \
            .levels = 3,                                                                           \
            .changes = WITH_HOLES | SCRAMBLED                                                      \
        }                                                                                          \
    }

#define CASES_SEVERAL_COMPONENTS(seed)                                                             \
    {"four-bodies", "several-components", (seed), PUBLIC | QUICK,                                  \
     .mesh = {SHAPE_TETRAHEDRON, .changes = WITH_COMPONENTS}},                                     \
    {                                                                                              \
        "four-mixed", "several-components", (seed) + 1, QUICK, .mesh = {                           \
            SHAPE_ICO,                                                                             \
            .levels = 2,                                                                           \
            .changes = WITH_COMPONENTS | SCRAMBLED                                                 \
        }                                                                                          \
    }

#define CASES_ISOLATED_VERTICES(seed)                                                              \
    {"cube-and-isolated", "isolated-vertices", (seed), PUBLIC | QUICK,                             \
     .mesh = {SHAPE_CUBE, .changes = WITH_ISOLATED}},                                              \
    {                                                                                              \
        "sphere-and-isolated", "isolated-vertices", (seed) + 1, QUICK, .mesh = {                   \
            SHAPE_ICO,                                                                             \
            .levels = 3,                                                                           \
            .changes = WITH_ISOLATED                                                               \
        }                                                                                          \
    }

#define CASES_INCOHERENT(seed)                                                                     \
    {"cube-flipped", "incoherent-orientation", (seed), PUBLIC | QUICK,                             \
     .mesh = {SHAPE_CUBE, .changes = FLIPPED}},                                                    \
        {"sphere-inside-out", "incoherent-orientation", (seed) + 1, HIDDEN,                        \
         .mesh = {SHAPE_ICO, .levels = 2, .changes = REVERSED | SCRAMBLED}},                       \
        {"sphere-flipped", "incoherent-orientation", (seed) + 2, QUICK,                            \
         .mesh = {SHAPE_ICO, .levels = 3, .changes = FLIPPED | SCRAMBLED}},                        \
        {"moebius-strip", "incoherent-orientation", (seed) + 3, QUICK,                             \
         .mesh = {SHAPE_MOEBIUS, .count = 40, .changes = SCRAMBLED}},                              \
    {                                                                                              \
        "moebius-flipped", "incoherent-orientation", (seed) + 4, HIDDEN, .mesh = {                 \
            SHAPE_MOEBIUS,                                                                         \
            .count = 33,                                                                           \
            .changes = FLIPPED | SCRAMBLED                                                         \
        }                                                                                          \
    }

#define CASES_NON_MANIFOLD_EDGE(seed)                                                              \
    {"two-cubes-at-an-edge", "non-manifold-edge", (seed), PUBLIC | QUICK,                          \
     .mesh = {SHAPE_TWO_CUBES}},                                                                   \
        {"two-cubes-scrambled", "non-manifold-edge", (seed) + 1, HIDDEN,                           \
         .mesh = {SHAPE_TWO_CUBES, .changes = SCRAMBLED}},                                         \
    {                                                                                              \
        "six-round-an-edge", "non-manifold-edge", (seed) + 2, QUICK, .mesh = {                     \
            SHAPE_ROUND_AN_EDGE,                                                                   \
            .count = 6,                                                                            \
            .changes = SCRAMBLED                                                                   \
        }                                                                                          \
    }

#define CASES_DEGENERATE_TRIANGLE(seed)                                                            \
    {"cube-degenerate", "degenerate-triangle", (seed), PUBLIC | QUICK,                             \
     .mesh = {SHAPE_CUBE, .changes = WITH_DEGENERATE | WITH_SPIKES}},                              \
        {"sphere-degenerate", "degenerate-triangle", (seed) + 1, QUICK,                            \
         .mesh = {SHAPE_ICO, .levels = 2, .changes = WITH_DEGENERATE | SCRAMBLED}},                \
    {                                                                                              \
        "sphere-and-spikes", "degenerate-triangle", (seed) + 2, HIDDEN, .mesh = {                  \
            SHAPE_ICO,                                                                             \
            .levels = 2,                                                                           \
            .changes = WITH_SPIKES | SCRAMBLED                                                     \
        }                                                                                          \
    }

#define CASES_DUPLICATE_TRIANGLE(seed)                                                             \
    {"tetrahedron-twice", "duplicate-triangle", (seed), PUBLIC | QUICK,                            \
     .mesh = {SHAPE_TETRAHEDRON, .changes = WITH_DUPLICATES}},                                     \
    {                                                                                              \
        "sphere-twice", "duplicate-triangle", (seed) + 1, QUICK, .mesh = {                         \
            SHAPE_ICO,                                                                             \
            .levels = 3,                                                                           \
            .changes = WITH_DUPLICATES | SCRAMBLED                                                 \
        }                                                                                          \
    }

#define CASES_HIGH_VALENCE(seed)                                                                   \
    {"bipyramid-40", "high-valence", (seed), PUBLIC, .mesh = {SHAPE_BIPYRAMID, .count = 40}},      \
    {                                                                                              \
        "bipyramid-150", "high-valence", (seed) + 1, QUICK, .mesh = {                              \
            SHAPE_BIPYRAMID,                                                                       \
            .count = 150,                                                                          \
            .changes = SCRAMBLED                                                                   \
        }                                                                                          \
    }

#define CASES_HIGH_NUMBERS(seed)                                                                   \
    {                                                                                              \
        "part-of-large-mesh", "high-numbers", (seed), QUICK, .mesh = {                             \
            SHAPE_ICO,                                                                             \
            .levels = 3,                                                                           \
            .changes = SCRAMBLED | HIGH_NUMBERS                                                    \
        }                                                                                          \
    }

/* Of exercises with INPUT_TOPOLOGY; memory_megabytes should be 512 or more. */
#define CASES_VAST_NUMBERS(seed)                                                                   \
    {                                                                                              \
        "part-of-vast-mesh", "high-numbers", (seed), HIDDEN, .mesh = {                             \
            SHAPE_ICO,                                                                             \
            .levels = 2,                                                                           \
            .changes = SCRAMBLED | VAST_NUMBERS                                                    \
        }                                                                                          \
    }

#define CASES_EMPTY(seed)                                                                          \
    {"nothing", "empty", (seed), PUBLIC | QUICK, .mesh = {SHAPE_EMPTY}},                           \
    {                                                                                              \
        "only-vertices", "empty", (seed) + 1, QUICK, .mesh = { SHAPE_ISOLATED, .count = 7 }        \
    }

#endif
