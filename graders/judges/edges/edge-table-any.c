/* Problem 4.5 (a): the edge table of any mesh. Judging is edge_table.h's; here are the cases. */
#include "graders/library/cases.h"
#include "graders/library/edge_table.h"

static const struct judge_case cases[] = {
    CASES_CLOSED(1),
    {"torus", "closed", 5, HIDDEN,
     .mesh = {SHAPE_TORUS, .genus = 1, .triangles = 1200, .changes = SCRAMBLED}},
    {"torus-genus-2", "closed", 6, QUICK,
     .mesh = {SHAPE_TORUS, .genus = 2, .triangles = 2400, .changes = ADVERSARIAL}},
    {"two-cones-at-apex", "closed", 7, HIDDEN,
     .mesh = {SHAPE_TWO_CONES, .count = 12, .changes = SCRAMBLED}},
    {"mug", "closed", 9, HIDDEN, .mesh = {SHAPE_MUG}},
    CASES_OPEN(11),
    CASES_OPEN_HOLES(16),
    CASES_INCOHERENT(21),
    CASES_SEVERAL_COMPONENTS(31),
    CASES_ISOLATED_VERTICES(41),
    CASES_NON_MANIFOLD_EDGE(51),
    CASES_DEGENERATE_TRIANGLE(61),
    CASES_DUPLICATE_TRIANGLE(71),
    CASES_HIGH_VALENCE(81),
    CASES_HIGH_NUMBERS(91),
    CASES_VAST_NUMBERS(92),
    CASES_EMPTY(101),
};

static const struct size_family families[] = {
    {"sphere-scrambled", FAMILY_SPHERE, SCRAMBLED},
    {"grid-scrambled-flipped", FAMILY_GRID, FLIPPED | SCRAMBLED},
    {"torus-adversarial", FAMILY_TORUS, ADVERSARIAL},
    {NULL},
};

static const struct answer_rule answer = EDGE_TABLE_ANSWER("edge_table_any");

const struct judge judge_edge_table_any = {
    .exercise = "edge-table-any",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .input = INPUT_TOPOLOGY,
    .families = families,
    .answer = &answer,
    .judge = edge_table_judge,
};
