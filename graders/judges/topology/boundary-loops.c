/* Judges boundary-loops: every boundary edge, in the direction in which its triangle runs it, is a
 * step of just one loop. Where two fans meet at a boundary vertex several cuts into loops are
 * right, so loops are judged step by step, not compared with a cut of our own. */
#include "graders/library/cases.h"
#include "graders/library/topology.h"

#include <inttypes.h>
#include <stdlib.h>

static const struct judge_case cases[] = {
    {"one-triangle", "disc", 1, PUBLIC | QUICK, .mesh = {SHAPE_ONE_TRIANGLE}},
    {"grid", "disc", 2, PUBLIC | QUICK, .mesh = {SHAPE_GRID, .rows = 3, .columns = 5}},
    {"disc-scrambled", "disc", 3, QUICK,
     .mesh = {SHAPE_DISC, .rings = 6, .sectors = 11, .changes = SCRAMBLED}},
    {"fan", "disc", 4, HIDDEN, .mesh = {SHAPE_FAN, .count = 9, .changes = SCRAMBLED}},
    {"annulus", "holes", 11, PUBLIC | QUICK, .mesh = {SHAPE_ANNULUS, .sectors = 7}},
    {"grid-with-windows", "holes", 12, PUBLIC | QUICK,
     .mesh = {SHAPE_GRID, .rows = 9, .columns = 11, .changes = WITH_WINDOWS}},
    {"sphere-with-windows", "holes", 13, QUICK,
     .mesh = {SHAPE_ICO, .levels = 3, .changes = WITH_WINDOWS | SCRAMBLED}},
    {"bunny", "holes", 14, HIDDEN, .mesh = {SHAPE_BUNNY, .changes = SCRAMBLED}},
    {"tetrahedron", "closed", 21, PUBLIC | QUICK, .mesh = {SHAPE_TETRAHEDRON}},
    {"torus", "closed", 22, QUICK,
     .mesh = {SHAPE_TORUS, .genus = 1, .triangles = 600, .changes = SCRAMBLED}},
    {"triangles-apart", "several-components", 31, PUBLIC | QUICK,
     .mesh = {SHAPE_SEPARATE, .count = 5}},
    {"annulus-and-bodies", "several-components", 32, QUICK,
     .mesh = {SHAPE_ANNULUS, .sectors = 9, .changes = WITH_COMPONENTS | SCRAMBLED}},
    {"bow-tie", "bow-tie", 41, PUBLIC | QUICK, .mesh = {SHAPE_BOW_TIE, .count = 2}},
    {"three-fans", "bow-tie", 42, QUICK, .mesh = {SHAPE_BOW_TIE, .count = 3, .changes = SCRAMBLED}},
    {"grid-and-isolated", "isolated-vertices", 51, PUBLIC | QUICK,
     .mesh = {SHAPE_GRID, .rows = 4, .columns = 4, .changes = WITH_ISOLATED | SCRAMBLED}},
    {"part-of-large-mesh", "high-numbers", 61, QUICK,
     .mesh = {SHAPE_GRID, .rows = 12, .columns = 9, .changes = SCRAMBLED | HIGH_NUMBERS}},
    {"long-loop", "long-loop", 71, HIDDEN,
     .mesh = {SHAPE_GRID, .rows = 1, .columns = 20000, .changes = SCRAMBLED}},
    CASES_EMPTY(81),
};

static const struct size_family families[] = {
    {"grid-scrambled", FAMILY_GRID, SCRAMBLED},
    {"grid-with-windows", FAMILY_WINDOWS, SCRAMBLED},
    {"triangles-apart", FAMILY_SEPARATE, SCRAMBLED},
    {NULL},
};

static const struct answer_rule answer = {.function = "boundary_loops",
                                          .result = RESULT_COUNT,
                                          .counted = {"loops", "bucles"},
                                          .most = {.per_face = 1},
                                          .parts = {{.argument = "*first or *vertices",
                                                     .row = {"loop", "bucle"},
                                                     .columns = 1,
                                                     .of = OF_VERTEX,
                                                     .rows = ROWS_OF_ROWS,
                                                     .most = {.per_face = 3}}}};

static const struct phrase loop_noun = {"loop", "bucle"};
static const struct phrase edge_noun = {"boundary edge", "arista de borde"};
static const struct phrase loops_found = {"loops of the answer", "bucles de la respuesta"};
static const struct cause empty_loop = {"empty-loop", {"empty loop", "bucle vacío"}};
static const struct cause repeated_vertex = {
    "vertex-repeated", {"vertex twice in a row", "vértice dos veces seguidas"}};
static const struct cause wrong_direction = {"wrong-direction",
                                             {"wrong direction", "sentido contrario"}};
static const struct cause no_boundary = {"not-a-boundary-edge",
                                         {"not a boundary edge", "no es una arista de borde"}};
static const struct cause repeated_edge = {"edge-repeated",
                                           {"boundary edge repeated", "arista de borde repetida"}};
static const struct cause missing_edge = {"loop-missing",
                                          {"boundary edge left out", "arista de borde omitida"}};

/* The boundary, and which edges the answer has passed. */
struct check {
    const struct face_topology *t;
    const struct answer_table *loops;
    bool *passed; /* of each edge */
};

static int64_t loop_length(const struct check *check, int64_t loop)
{
    return check->loops->first[loop + 1] - check->loops->first[loop];
}

static int32_t loop_vertex(const struct check *check, int64_t loop, int64_t i)
{
    return answer_int(check->loops, check->loops->first[loop] + i % loop_length(check, loop), 0);
}

/* Says what is wrong with the step of a loop from a to b; `edge` -1: there is none. */
static void reject_step(const struct check *check, int64_t loop, int64_t i, int64_t edge,
                        struct judgement *out)
{
    int32_t a = loop_vertex(check, loop, i), b = loop_vertex(check, loop, i + 1);
    bool last = i + 1 == loop_length(check, loop);
    judge_name_one(out, loop_noun, "%" PRId64 ", (%d,%d)", loop, a, b);
    if (a == b) {
        judge_reject(out, &repeated_vertex, "loop %" PRId64 " has vertex %d twice in a row.",
                     "el bucle %" PRId64 " tiene el vértice %d dos veces seguidas.", loop, a);
        if (last && loop_length(check, loop) > 1)
            judge_hint(out,
                       (struct phrase){
                           "The first vertex is not repeated at the end: the last one is joined "
                           "to it anyway.",
                           "El primer vértice no se repite al final: el último ya se une con "
                           "él."});
    } else if (edge < 0 || topology_side_count(&check->t->edges[edge]) != 1) {
        judge_reject(
            out, &no_boundary, "loop %" PRId64 " goes from %d to %d, which is no boundary edge.",
            "el bucle %" PRId64 " va de %d a %d, que no es una arista de borde.", loop, a, b);
    } else if (check->passed[edge]) {
        judge_reject(out, &repeated_edge,
                     "loop %" PRId64 " goes from %d to %d, an edge that a loop has passed already.",
                     "el bucle %" PRId64 " va de %d a %d, una arista por la que ya pasó un bucle.",
                     loop, a, b);
    } else {
        judge_reject(
            out, &wrong_direction,
            "loop %" PRId64 " goes from %d to %d, but the triangle at this edge runs it from "
            "%d to %d.",
            "el bucle %" PRId64 " va de %d a %d, pero el triángulo de esa arista la recorre "
            "de %d a %d.",
            loop, a, b, b, a);
    }
    scene_mark_arrow(&out->scene, MARK_WRONG, a, b);
    if (out->cause[0] && edge >= 0 && topology_side_count(&check->t->edges[edge]) == 1)
        scene_mark_arrow(&out->scene, MARK_RIGHT, b, a);
}

/* Follows one loop. Returns whether all of its steps are right. */
static bool follow_loop(struct check *check, int64_t loop, struct judgement *out)
{
    if (loop_length(check, loop) == 0) {
        judge_name_one(out, loop_noun, "%" PRId64, loop);
        judge_reject(out, &empty_loop, "loop %" PRId64 " has no vertex.",
                     "el bucle %" PRId64 " no tiene ningún vértice.", loop);
        return false;
    }
    for (int64_t i = 0; i < loop_length(check, loop); i++) {
        int32_t a = loop_vertex(check, loop, i), b = loop_vertex(check, loop, i + 1);
        int64_t edge = topology_find_edge(check->t, a, b);
        const struct face_edge *found = edge < 0 ? NULL : &check->t->edges[edge];
        bool right = found && topology_side_count(found) == 1 && !check->passed[edge] &&
                     (found->up_count == 1) == (a < b);
        if (!right) {
            reject_step(check, loop, i, edge, out);
            return false;
        }
        check->passed[edge] = true;
    }
    return true;
}

/* The step that the surface's triangle makes along a boundary edge. */
static void mark_missing(const struct face_edge *edge, struct scene *scene)
{
    bool up = edge->up_count == 1;
    scene_mark_arrow(scene, MARK_MISSING, up ? edge->low : edge->high, up ? edge->high : edge->low);
}

static void reject_missing(const struct check *check, struct judgement *out)
{
    int64_t missing = 0, first = -1;
    for (int64_t e = 0; e < check->t->edge_count; e++) {
        const struct face_edge *edge = &check->t->edges[e];
        if (topology_side_count(edge) != 1 || check->passed[e])
            continue;
        first = missing++ == 0 ? e : first;
        mark_missing(edge, &out->scene);
    }
    if (first < 0)
        return;
    const struct face_edge *edge = &check->t->edges[first];
    bool up = edge->up_count == 1;
    int32_t from = up ? edge->low : edge->high, to = up ? edge->high : edge->low;
    judge_name_one(out, edge_noun, "(%d,%d)", from, to);
    judge_reject(out, &missing_edge,
                 "no loop passes the boundary edge from %d to %d. Boundary edges left out: %" PRId64
                 " of %" PRId64 ".",
                 "ningún bucle pasa por la arista de borde de %d a %d. Aristas de borde omitidas: "
                 "%" PRId64 " de %" PRId64 ".",
                 from, to, missing, check->t->boundary.count);
}

/* The loops of the answer in turn colours, behind what is wrong. */
static int show(const struct task *task, const struct check *check, struct judgement *out,
                struct error *err)
{
    for (int64_t l = 0; l < check->loops->row_count; l++)
        scene_mark_path(&out->scene, mark_turn(l),
                        (const int32_t *)check->loops->cells + check->loops->first[l],
                        loop_length(check, l), true);
    scene_name_turns(&out->scene, loops_found, check->loops->row_count);
    out->scene.ok_count = -1;
    return task_show(task, out, err);
}

static int judge(const struct task *task, struct judgement *out, struct error *err)
{
    const struct face_table faces = {NULL, task->mesh.triangles, task->sizes.faces,
                                     task->sizes.corners, task->mesh.vertex_count};
    struct face_topology t;
    if (topology_build(&faces, &t, err))
        return -1;
    struct check check = {&t, &task->answer.table[0], calloc((size_t)t.edge_count + 1, 1)};
    int failed = check.passed ? 0 : error_set(err, "out of memory for %d edges", (int)t.edge_count);
    bool right = !failed;
    for (int64_t l = 0; right && l < check.loops->row_count; l++)
        right = follow_loop(&check, l, out);
    if (right)
        reject_missing(&check, out);
    if (!failed && !out->cause[0])
        judge_accept(out);
    else if (!failed)
        failed = show(task, &check, out, err);
    free(check.passed);
    topology_release(&t);
    return failed;
}

const struct judge judge_boundary_loops = {
    .exercise = "boundary-loops",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .input = INPUT_TOPOLOGY,
    .families = families,
    .answer = &answer,
    .judge = judge,
};
