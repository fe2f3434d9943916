/* Judges winged-edge-build. What must be refused is refusal.h's, rows are winged_judge.h's; here
 * are the cases. */
#include "graders/library/cases.h"
#include "graders/library/refusal.h"
#include "graders/library/winged_judge.h"

/* clang-format off */
#define REFUSED(name, seed, runs, ...) {name, "refused", seed, runs, .mesh = {__VA_ARGS__}}
static const struct judge_case cases[] = {
    CASES_CLOSED(1), CASES_GENUS(11), CASES_SEVERAL_COMPONENTS(31), CASES_ISOLATED_VERTICES(41),
    CASES_HIGH_VALENCE(81), CASES_HIGH_NUMBERS(91), CASES_EMPTY(101),
    {"course-prism", "polygons", 21, PUBLIC | QUICK, .mesh = {SHAPE_COURSE_PRISM}},
    {"cube-of-quads", "polygons", 22, QUICK, .mesh = {SHAPE_QUAD_CUBE, .changes = SCRAMBLED}},
    {"prism-40", "polygons", 23, QUICK, .mesh = {SHAPE_PRISM, .count = 40, .changes = SCRAMBLED}},
    {"grid", "open", 51, PUBLIC | QUICK, .mesh = {SHAPE_GRID, .rows = 3, .columns = 5}},
    {"annulus", "open", 52, QUICK, .mesh = {SHAPE_ANNULUS, .sectors = 9, .changes = SCRAMBLED}},
    {"quads", "open", 53, HIDDEN,
     .mesh = {SHAPE_QUAD_GRID, .rows = 24, .columns = 31, .changes = SCRAMBLED}},
    {"single-triangle", "one-element", 61, PUBLIC | QUICK, .mesh = {SHAPE_ONE_TRIANGLE}},
    {"single-pentagon", "one-element", 62, QUICK, .mesh = {SHAPE_POLYGON, .count = 5}},
    REFUSED("two-cones", 71, PUBLIC | QUICK, SHAPE_TWO_CONES, .count = 6),
    REFUSED("bow-tie", 72, QUICK, SHAPE_BOW_TIE, .count = 2, .changes = SCRAMBLED),
    REFUSED("book", 73, PUBLIC | QUICK, SHAPE_BOOK, .count = 3),
    REFUSED("two-cubes", 74, QUICK, SHAPE_TWO_CUBES, .changes = SCRAMBLED),
    REFUSED("cube-flipped", 75, PUBLIC | QUICK, SHAPE_QUAD_CUBE, .changes = FLIPPED),
    REFUSED("moebius-strip", 76, QUICK, SHAPE_MOEBIUS, .count = 12, .changes = SCRAMBLED),
};

static const struct size_family families[] = {{"sphere-scrambled", FAMILY_SPHERE, SCRAMBLED},
                                              {"quads-scrambled", FAMILY_QUADS, SCRAMBLED},
                                              {"grid-scrambled", FAMILY_GRID, SCRAMBLED},
                                              {NULL}};

static const struct answer_rule answer = {
    .function = "winged_edge_build", .result = RESULT_COUNT, .counted = {"edges", "aristas"},
    .most = {.per_corner = 1},
    .parts = {{.argument = "*edges", .row = {"edge", "arista"}, .columns = 8,
               .column = {{"vi", OF_VERTEX}, {"vf", OF_VERTEX},
                          {"cd", OF_FACE, true}, {"ci", OF_FACE, true},
                          {"ada", OF_RESULT, true}, {"ads", OF_RESULT, true},
                          {"aia", OF_RESULT, true}, {"ais", OF_RESULT, true}}},
              {.argument = "vertex_edge", .row = {"vertex", "vértice"}, .columns = 1,
               .of = OF_RESULT, .may_be_none = true, .rows = ROWS_FIXED, .most = {.per_vertex = 1}},
              {.argument = "face_edge", .row = {"face", "cara"}, .columns = 1,
               .of = OF_RESULT, .may_be_none = true, .rows = ROWS_FIXED, .most = {.per_face = 1}}},
    .codes = {{-2, "NOT_MANIFOLD"}, {-3, "NOT_ORIENTABLE"}}};
/* clang-format on */

static int judge(const struct task *task, struct judgement *out, struct error *err)
{
    const struct face_table faces = {task->polygons.first_corner, task->polygons.corners,
                                     task->sizes.faces, task->sizes.corners,
                                     task->polygons.vertex_count};
    const struct answer_table *tables = task->answer.table;
    const struct structure_answer rows = {STRUCTURE_WINGED_EDGE, tables[0].cells,
                                          structure_winged_get,  tables[0].count,
                                          tables[1].cells,       tables[2].cells};
    struct face_topology topology;
    struct message why;
    if (topology_build(&faces, &topology, err))
        return -1;
    const char *wanted = refusal_of(&topology, &why, &out->scene);
    bool goes_on = answer_refuses_rightly(&answer, &task->answer, wanted, &why, out);
    topology_release(&topology);
    if (goes_on && winged_judge(&faces, &rows, out, err))
        return -1;
    out->scene.ok_count = -1;
    return out->accepted ? 0 : task_show(task, out, err);
}

const struct judge judge_winged_edge_build = {
    .exercise = "winged-edge-build",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .input = INPUT_POLYGONS,
    .families = families,
    .answer = &answer,
    .judge = judge,
};
