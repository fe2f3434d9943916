/* Problem 4.5 (b): the edge table of a closed, coherently oriented mesh. Judging is edge_table.h's;
 * here are the cases.
 *
 * Each class is pure: only `genus` has more than 3 (V - 2) edges, only the bipyramid of `closed`
 * has vertices with more than 32 neighbours, and only `high-numbers` has numbers that overflow 16
 * bits, or 32 bits when multiplied. */
#include "graders/library/edge_table.h"
#include "graders/library/mesh_case.h"

enum { HIDDEN = false, PUBLIC = true, QUICK = true, FULL = false };

static const char CLOSED[] = "closed";
static const char GENUS[] = "genus";
static const char BODIES[] = "several-components";
static const char ISOLATED[] = "isolated-vertices";
static const char NUMBERS[] = "high-numbers";
static const char EMPTY[] = "empty";

static const struct judge_case cases[] = {
    {"tetrahedron", CLOSED, 1, {SHAPE_TETRAHEDRON}, PUBLIC, QUICK},
    {"cube", CLOSED, 2, {SHAPE_CUBE}, PUBLIC, QUICK},
    {"cube-scrambled", CLOSED, 3, {SHAPE_CUBE, 0, 0, SCRAMBLED}, HIDDEN, FULL},
    {"sphere", CLOSED, 4, {SHAPE_UV_SPHERE, 12, 20}, HIDDEN, FULL},
    {"icosphere-scrambled", CLOSED, 5, {SHAPE_ICO, 3, 0, SCRAMBLED}, HIDDEN, QUICK},
    {"sphere-inside-out", CLOSED, 6, {SHAPE_ICO, 2, 0, REVERSED | SCRAMBLED}, HIDDEN, FULL},
    {"bipyramid-60", CLOSED, 7, {SHAPE_BIPYRAMID, 60, 0, SCRAMBLED}, HIDDEN, QUICK},
    {"two-cones-at-apex", CLOSED, 8, {SHAPE_TWO_CONES, 12, 0, SCRAMBLED}, HIDDEN, FULL},
    {"horse", CLOSED, 9, {SHAPE_HORSE, 0, 0, SCRAMBLED}, HIDDEN, FULL},

    {"torus", GENUS, 11, {SHAPE_TORUS, 1, 600}, PUBLIC, QUICK},
    {"torus-adversarial", GENUS, 12, {SHAPE_TORUS, 1, 1200, ADVERSARIAL}, HIDDEN, FULL},
    {"torus-genus-2", GENUS, 13, {SHAPE_TORUS, 2, 2400, SCRAMBLED}, HIDDEN, QUICK},
    {"torus-genus-3", GENUS, 14, {SHAPE_TORUS, 3, 2400, SCRAMBLED}, HIDDEN, FULL},
    {"mug", GENUS, 15, {SHAPE_MUG}, HIDDEN, FULL},

    {"four-bodies", BODIES, 21, {SHAPE_TETRAHEDRON, 0, 0, WITH_COMPONENTS}, PUBLIC, QUICK},
    {"four-mixed", BODIES, 22, {SHAPE_ICO, 2, 0, WITH_COMPONENTS | SCRAMBLED}, HIDDEN, QUICK},

    {"cube-and-isolated", ISOLATED, 31, {SHAPE_CUBE, 0, 0, WITH_ISOLATED}, PUBLIC, QUICK},
    {"sphere-and-isolated", ISOLATED, 32, {SHAPE_ICO, 3, 0, WITH_ISOLATED}, HIDDEN, QUICK},

    {"part-of-large-mesh", NUMBERS, 41, {SHAPE_ICO, 3, 0, SCRAMBLED | HIGH_NUMBERS}, HIDDEN, QUICK},

    {"nothing", EMPTY, 51, {SHAPE_EMPTY}, PUBLIC, QUICK},
    {"only-vertices", EMPTY, 52, {SHAPE_ISOLATED, 7}, HIDDEN, QUICK},
};

static const char *const families[] = {"sphere-scrambled", "torus-adversarial", NULL};

enum { FAMILY_WIDTH = 8 }; /* a constant valence at the poles */

static int make_sized(int family, int64_t size, uint64_t seed, struct writer *input,
                      struct error *err)
{
    const struct judge_case of_family[] = {
        {.seed = seed,
         .parameter = {SHAPE_UV_SPHERE, FAMILY_WIDTH, size / 2 / FAMILY_WIDTH, SCRAMBLED}},
        {.seed = seed, .parameter = {SHAPE_TORUS, 1, size, ADVERSARIAL}},
    };
    return mesh_case_write_input(&of_family[family], NULL, input, err);
}

const struct judge judge_edge_table_closed = {
    .exercise = "edge-table-closed",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .make = mesh_case_write_input,
    .families = families,
    .make_sized = make_sized,
    .judge = edge_table_judge,
    .answer_bound = edge_table_answer_bound,
};
