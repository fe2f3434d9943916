/* Problem 4.5 (a): the edge table of any mesh. Judging is edge_table.h's; here are the cases.
 *
 * Each class is pure, so that a mistake shows in the class that is named after it: meshes are
 * closed but in `open` (and the Moebius strip), coherent but in `incoherent-orientation`, in one
 * component but in `several-components`, and so on. Only bodies with handles, in `closed`, have
 * more than 3 (V - 2) edges, only `high-valence` has vertices with more than 32 neighbours, and
 * only `high-numbers` has numbers that overflow 16 bits, or 32 bits when multiplied. */
#include "graders/library/edge_table.h"
#include "graders/library/mesh_case.h"

enum { HIDDEN = false, PUBLIC = true, QUICK = true, FULL = false };

static const char CLOSED[] = "closed";
static const char OPEN[] = "open";
static const char FLIPS[] = "incoherent-orientation";
static const char BODIES[] = "several-components";
static const char ISOLATED[] = "isolated-vertices";
static const char NON_MANIFOLD[] = "non-manifold-edge";
static const char FLAT[] = "degenerate-triangle";
static const char DUPLICATE[] = "duplicate-triangle";
static const char VALENCE[] = "high-valence";
static const char NUMBERS[] = "high-numbers";
static const char EMPTY[] = "empty";

static const struct judge_case cases[] = {
    {"tetrahedron", CLOSED, 1, {SHAPE_TETRAHEDRON}, PUBLIC, QUICK},
    {"cube", CLOSED, 2, {SHAPE_CUBE, 0, 0, SCRAMBLED}, HIDDEN, QUICK},
    {"sphere", CLOSED, 3, {SHAPE_UV_SPHERE, 24, 20}, PUBLIC, FULL},
    {"icosphere-scrambled", CLOSED, 4, {SHAPE_ICO, 3, 0, SCRAMBLED}, HIDDEN, QUICK},
    {"torus", CLOSED, 5, {SHAPE_TORUS, 1, 1200, SCRAMBLED}, HIDDEN, FULL},
    {"torus-genus-2", CLOSED, 6, {SHAPE_TORUS, 2, 2400, ADVERSARIAL}, HIDDEN, QUICK},
    {"two-cones-at-apex", CLOSED, 7, {SHAPE_TWO_CONES, 12, 0, SCRAMBLED}, HIDDEN, FULL},
    {"horse", CLOSED, 8, {SHAPE_HORSE, 0, 0, SCRAMBLED}, HIDDEN, FULL},
    {"mug", CLOSED, 9, {SHAPE_MUG}, HIDDEN, FULL},

    {"one-triangle", OPEN, 11, {SHAPE_ONE_TRIANGLE}, PUBLIC, QUICK},
    {"grid", OPEN, 12, {SHAPE_GRID, 4, 8}, PUBLIC, QUICK},
    {"grid-scrambled", OPEN, 13, {SHAPE_GRID, 24, 31, SCRAMBLED}, HIDDEN, QUICK},
    {"disc-scrambled", OPEN, 14, {SHAPE_DISC, 8, 12, SCRAMBLED}, HIDDEN, FULL},
    {"fan", OPEN, 15, {SHAPE_FAN, 9, 0, SCRAMBLED}, HIDDEN, FULL},
    {"sphere-with-holes", OPEN, 16, {SHAPE_ICO, 3, 0, WITH_HOLES | SCRAMBLED}, HIDDEN, FULL},
    {"bunny", OPEN, 17, {SHAPE_BUNNY, 0, 0, SCRAMBLED}, HIDDEN, QUICK},

    {"cube-flipped", FLIPS, 21, {SHAPE_CUBE, 0, 0, FLIPPED}, PUBLIC, QUICK},
    {"sphere-inside-out", FLIPS, 22, {SHAPE_ICO, 2, 0, REVERSED | SCRAMBLED}, HIDDEN, FULL},
    {"sphere-flipped", FLIPS, 23, {SHAPE_ICO, 3, 0, FLIPPED | SCRAMBLED}, HIDDEN, QUICK},
    {"moebius-strip", FLIPS, 24, {SHAPE_MOEBIUS, 40, 0, SCRAMBLED}, HIDDEN, QUICK},
    {"moebius-flipped", FLIPS, 25, {SHAPE_MOEBIUS, 33, 0, FLIPPED | SCRAMBLED}, HIDDEN, FULL},

    {"four-bodies", BODIES, 31, {SHAPE_TETRAHEDRON, 0, 0, WITH_COMPONENTS}, PUBLIC, QUICK},
    {"four-mixed", BODIES, 32, {SHAPE_ICO, 2, 0, WITH_COMPONENTS | SCRAMBLED}, HIDDEN, QUICK},

    {"cube-and-isolated", ISOLATED, 41, {SHAPE_CUBE, 0, 0, WITH_ISOLATED}, PUBLIC, QUICK},
    {"sphere-and-isolated", ISOLATED, 42, {SHAPE_ICO, 3, 0, WITH_ISOLATED}, HIDDEN, QUICK},

    {"two-cubes-at-an-edge", NON_MANIFOLD, 51, {SHAPE_TWO_CUBES}, PUBLIC, QUICK},
    {"two-cubes-scrambled", NON_MANIFOLD, 52, {SHAPE_TWO_CUBES, 0, 0, SCRAMBLED}, HIDDEN, FULL},
    {"six-round-an-edge", NON_MANIFOLD, 53, {SHAPE_ROUND_AN_EDGE, 6, 0, SCRAMBLED}, HIDDEN, QUICK},

    {"cube-degenerate", FLAT, 61, {SHAPE_CUBE, 0, 0, WITH_DEGENERATE | WITH_SPIKES}, PUBLIC, QUICK},
    {"sphere-degenerate", FLAT, 62, {SHAPE_ICO, 2, 0, WITH_DEGENERATE | SCRAMBLED}, HIDDEN, QUICK},
    {"sphere-and-spikes", FLAT, 63, {SHAPE_ICO, 2, 0, WITH_SPIKES | SCRAMBLED}, HIDDEN, FULL},

    {"tetrahedron-twice", DUPLICATE, 71, {SHAPE_TETRAHEDRON, 0, 0, WITH_DUPLICATES}, PUBLIC, QUICK},
    {"sphere-twice", DUPLICATE, 72, {SHAPE_ICO, 3, 0, WITH_DUPLICATES | SCRAMBLED}, HIDDEN, QUICK},

    {"bipyramid-40", VALENCE, 81, {SHAPE_BIPYRAMID, 40}, PUBLIC, FULL},
    {"bipyramid-150", VALENCE, 82, {SHAPE_BIPYRAMID, 150, 0, SCRAMBLED}, HIDDEN, QUICK},

    {"part-of-large-mesh", NUMBERS, 91, {SHAPE_ICO, 3, 0, SCRAMBLED | HIGH_NUMBERS}, HIDDEN, QUICK},

    {"nothing", EMPTY, 101, {SHAPE_EMPTY}, PUBLIC, QUICK},
    {"only-vertices", EMPTY, 102, {SHAPE_ISOLATED, 7}, HIDDEN, QUICK},
};

static const char *const families[] = {"sphere-scrambled", "grid-scrambled-flipped",
                                       "torus-adversarial", NULL};

enum { FAMILY_WIDTH = 8 }; /* a constant valence at the poles, a constant share of boundary */

static int make_sized(int family, int64_t size, uint64_t seed, struct writer *input,
                      struct error *err)
{
    int64_t length = size / 2 / FAMILY_WIDTH;
    const struct judge_case of_family[] = {
        {.seed = seed, .parameter = {SHAPE_UV_SPHERE, FAMILY_WIDTH, length, SCRAMBLED}},
        {.seed = seed, .parameter = {SHAPE_GRID, length, FAMILY_WIDTH, FLIPPED | SCRAMBLED}},
        {.seed = seed, .parameter = {SHAPE_TORUS, 1, size, ADVERSARIAL}},
    };
    return mesh_case_write_input(&of_family[family], NULL, input, err);
}

const struct judge judge_edge_table_any = {
    .exercise = "edge-table-any",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .make = mesh_case_write_input,
    .families = families,
    .make_sized = make_sized,
    .judge = edge_table_judge,
    .answer_bound = edge_table_answer_bound,
};
