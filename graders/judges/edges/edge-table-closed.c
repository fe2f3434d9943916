/* Problem 4.5 (b): the edge table of a closed, coherently oriented mesh. Judging is edge_table.h's;
 * here are the cases. Only `genus` has more than 3 (V - 2) edges, only the bipyramid of `closed`
 * has vertices with more than 32 neighbours. */
#include "graders/library/cases.h"
#include "graders/library/edge_table.h"

static const struct judge_case cases[] = {
    CASES_CLOSED(1),
    {"sphere-inside-out", "closed", 6, HIDDEN,
     .mesh = {SHAPE_ICO, .levels = 2, .changes = REVERSED | SCRAMBLED}},
    {"bipyramid-60", "closed", 7, QUICK,
     .mesh = {SHAPE_BIPYRAMID, .count = 60, .changes = SCRAMBLED}},
    {"two-cones-at-apex", "closed", 9, HIDDEN,
     .mesh = {SHAPE_TWO_CONES, .count = 12, .changes = SCRAMBLED}},
    CASES_GENUS(11),
    CASES_SEVERAL_COMPONENTS(21),
    CASES_ISOLATED_VERTICES(31),
    CASES_HIGH_NUMBERS(41),
    CASES_VAST_NUMBERS(42),
    CASES_EMPTY(51),
};

static const struct size_family families[] = {
    {"sphere-scrambled", FAMILY_SPHERE, SCRAMBLED},
    {"torus-adversarial", FAMILY_TORUS, ADVERSARIAL},
    {NULL},
};

static const struct answer_rule answer = EDGE_TABLE_ANSWER("edge_table_closed");

const struct judge judge_edge_table_closed = {
    .exercise = "edge-table-closed",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .input = INPUT_TOPOLOGY,
    .families = families,
    .answer = &answer,
    .judge = edge_table_judge,
};
