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
    {"disc-and-bodies", "several-components", 32, QUICK,
     .mesh = {SHAPE_DISC, .rings = 3, .sectors = 9, .changes = WITH_COMPONENTS | SCRAMBLED}},
    {"bow-tie", "bow-tie", 41, PUBLIC | QUICK, .mesh = {SHAPE_BOW_TIE, .count = 2}},
    {"three-fans", "bow-tie", 42, QUICK, .mesh = {SHAPE_BOW_TIE, .count = 3, .changes = SCRAMBLED}},
    {"grid-and-isolated", "isolated-vertices", 51, PUBLIC | QUICK,
     .mesh = {SHAPE_GRID, .rows = 4, .columns = 4, .changes = WITH_ISOLATED | SCRAMBLED}},
    {"disc-and-isolated", "isolated-vertices", 52, QUICK,
     .mesh = {SHAPE_DISC, .rings = 4, .sectors = 8, .changes = WITH_ISOLATED | SCRAMBLED}},
    {"part-of-large-mesh", "high-numbers", 61, QUICK,
     .mesh = {SHAPE_GRID, .rows = 12, .columns = 9, .changes = SCRAMBLED | HIGH_NUMBERS}},
    {"part-of-vast-mesh", "high-numbers", 62, HIDDEN,
     .mesh = {SHAPE_GRID, .rows = 9, .columns = 7, .changes = SCRAMBLED | VAST_NUMBERS}},
    {"long-loop", "long-loop", 71, HIDDEN,
     .mesh = {SHAPE_GRID, .rows = 1, .columns = 20000, .changes = SCRAMBLED}},
    CASES_EMPTY(81),
};

static const struct size_family families[] = {
    {"strip-scrambled", FAMILY_STRIP, SCRAMBLED},
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
static const struct phrase not_repeated = {"The first vertex is not repeated at the end of a loop.",
                                           "El primer vértice no se repite al final del bucle."};
static const struct phrase inner_edge = {"This edge has two triangles.",
                                         "Esa arista tiene dos triángulos."};
static const struct phrase no_edge = {"No triangle joins these two vertices.",
                                      "Ningún triángulo une esos dos vértices."};
static const struct cause short_loop = {"short-loop", {"loop too short", "bucle demasiado corto"}};
static const struct cause repeated_vertex = {
    "vertex-repeated", {"vertex twice in a row", "vértice dos veces seguidas"}};
static const struct cause wrong_direction = {"wrong-direction",
                                             {"wrong direction", "sentido contrario"}};
static const struct cause no_boundary = {"not-a-boundary-edge",
                                         {"not a boundary edge", "no es una arista de borde"}};
static const struct cause repeated_edge = {"edge-repeated",
                                           {"boundary edge repeated", "arista de borde repetida"}};
static const struct cause missing_edge = {"edge-left-out",
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

static const int32_t *loop_vertices(const struct check *check, int64_t loop)
{
    return (const int32_t *)check->loops->cells + check->loops->first[loop];
}

static int32_t loop_vertex(const struct check *check, int64_t loop, int64_t i)
{
    return loop_vertices(check, loop)[i % loop_length(check, loop)];
}

/* Says what is wrong with step i of a loop; `edge` NULL: no triangle has it. */
static void reject_step(const struct check *check, int64_t loop, int64_t i,
                        const struct face_edge *edge, struct judgement *out)
{
    int32_t a = loop_vertex(check, loop, i), b = loop_vertex(check, loop, i + 1);
    bool is_boundary = edge && topology_side_count(edge) == 1;
    bool is_reverse = is_boundary && (edge->up_count == 1) != (a < b);
    bool is_last = i + 1 == loop_length(check, loop);
    judge_name_one(out, loop_noun, "%" PRId64 ", (%d,%d)", loop, a, b);
    judge_reject_for(out, a == b         ? &repeated_vertex
                          : is_reverse   ? &wrong_direction
                          : !is_boundary ? &no_boundary
                                         : &repeated_edge);
    judge_en(out, "loop %" PRId64 " goes %sfrom %d to %d", loop, is_last ? "back " : "", a, b);
    judge_es(out, "el bucle %" PRId64 " %s de %d a %d", loop, is_last ? "vuelve" : "va", a, b);
    scene_mark_arrow(&out->scene, MARK_WRONG, a, b);
    if (is_reverse) {
        judge_en(out, ", but the triangle of this edge runs it from %d to %d.", b, a);
        judge_es(out, ", pero el triángulo de esa arista la recorre de %d a %d.", b, a);
    } else if (is_boundary) {
        judge_en(out, ", but a loop has passed this edge before.");
        judge_es(out, ", pero un bucle ya ha pasado por esa arista.");
    } else {
        judge_en(out, ", which is no boundary edge.");
        judge_es(out, ", que no es una arista de borde.");
    }
    if (a == b && is_last)
        judge_hint(out, not_repeated);
    else if (a != b && !is_boundary)
        judge_hint(out, edge ? inner_edge : no_edge);
}

/* Follows one loop. */
static void follow_loop(struct check *check, int64_t loop, struct judgement *out)
{
    int64_t length = loop_length(check, loop);
    if (length < 3) {
        judge_name_one(out, loop_noun, "%" PRId64, loop);
        judge_reject(out, &short_loop, "loop %" PRId64 " has fewer than 3 vertices.",
                     "el bucle %" PRId64 " tiene menos de 3 vértices.", loop);
        scene_mark_path(&out->scene, MARK_WRONG, loop_vertices(check, loop), length, false);
    }
    for (int64_t i = 0; i < length && !out->cause[0]; i++) {
        int32_t a = loop_vertex(check, loop, i), b = loop_vertex(check, loop, i + 1);
        int64_t e = topology_find_edge(check->t, a, b);
        const struct face_edge *edge = e < 0 ? NULL : &check->t->edges[e];
        if (!edge || topology_side_count(edge) != 1 || check->passed[e] ||
            (edge->up_count == 1) != (a < b))
            reject_step(check, loop, i, edge, out);
        else
            check->passed[e] = true;
    }
}

static void reject_missing(const struct check *check, struct judgement *out)
{
    int64_t missing = 0;
    for (int64_t e = 0; e < check->t->edge_count; e++) {
        const struct face_edge *edge = &check->t->edges[e];
        if (topology_side_count(edge) != 1 || check->passed[e])
            continue;
        int32_t from = edge->up_count == 1 ? edge->low : edge->high; /* as its triangle runs it */
        int32_t to = edge->up_count == 1 ? edge->high : edge->low;
        scene_mark_arrow(&out->scene, MARK_MISSING, from, to);
        if (missing++ > 0)
            continue;
        judge_name_one(out, edge_noun, "(%d,%d)", from, to);
        judge_reject(out, &missing_edge, "no loop passes the boundary edge from %d to %d.",
                     "ningún bucle pasa por la arista de borde de %d a %d.", from, to);
    }
    int64_t all = check->t->boundary.count;
    if (missing > 0) {
        judge_en(out, " Left out: %" PRId64 " of %" PRId64 " boundary edges.", missing, all);
        judge_es(out, " Omitidas: %" PRId64 " de %" PRId64 " aristas de borde.", missing, all);
    }
}

/* The loops of the answer in turn colours, behind what is wrong. */
static int show(const struct task *task, const struct check *check, struct judgement *out,
                struct error *err)
{
    for (int64_t l = 0; l < check->loops->row_count; l++)
        scene_mark_path(&out->scene, mark_turn(l), loop_vertices(check, l), loop_length(check, l),
                        true);
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
    for (int64_t l = 0; !failed && !out->cause[0] && l < check.loops->row_count; l++)
        follow_loop(&check, l, out);
    if (!failed && !out->cause[0])
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
