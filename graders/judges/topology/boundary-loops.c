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
     .mesh = {SHAPE_GRID, .rows = 1, .columns = 6000, .changes = SCRAMBLED}},
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
                                                     .offsets = "*first",
                                                     .values = "*vertices",
                                                     .row = {"loop", "bucle"},
                                                     .columns = 1,
                                                     .of = OF_VERTEX,
                                                     .rows = ROWS_OF_ROWS,
                                                     .most = {.per_face = 3}}}};

static const struct phrase loop_noun = {"loop", "bucle"};
static const struct phrase edge_noun = {"boundary edge", "arista de borde"};
static const struct phrase loops_found = {"loops of the answer", "bucles de la respuesta"};
static const struct cause empty_loop = {"empty-loop", {"empty loop", "bucle vacío"}};
static const struct cause missing_edge = {"edge-left-out",
                                          {"boundary edge left out", "arista de borde omitida"}};

/* What can be wrong with a step, and how its sentence goes on. */
struct fault {
    struct cause cause;
    struct phrase says;
};
static const struct fault repeated_vertex = {
    {"vertex-repeated", {"vertex twice in a row", "vértice dos veces seguidas"}},
    {": the first vertex of a loop is not repeated at its end, nor any other.",
     ": el primer vértice de un bucle no se repite al final, ni ningún otro."}};
static const struct fault no_edge = {
    {"no-edge", {"not an edge", "no es una arista"}},
    {", but no triangle joins these two vertices.", ", pero ningún triángulo une esos vértices."}};
static const struct fault inner_edge = {
    {"inner-edge", {"not a boundary edge", "no es una arista de borde"}},
    {", but this edge has two triangles.", ", pero esa arista tiene dos triángulos."}};
static const struct fault wrong_direction = {
    {"wrong-direction", {"wrong direction", "sentido contrario"}},
    {", against the direction of its triangle.", ", en sentido contrario al de su triángulo."}};
static const struct fault repeated_edge = {
    {"edge-repeated", {"boundary edge repeated", "arista de borde repetida"}},
    {", but a loop has passed this edge before.", ", pero un bucle ya ha pasado por esa arista."}};

/* The boundary, and which of its edges the answer has passed. */
struct check {
    const struct face_topology *t;
    const struct answer_table *loops;
    bool *passed; /* of each edge */
    int64_t passed_count;
};

static int64_t loop_length(const struct check *check, int64_t loop)
{
    return check->loops->first[loop + 1] - check->loops->first[loop];
}

/* The vertices of a loop. */
static const int32_t *loop_vertices(const struct check *check, int64_t loop)
{
    return (const int32_t *)check->loops->cells + check->loops->first[loop];
}

/* Passes the edge from a to b. Returns what is wrong with that, or NULL. */
static const struct fault *pass_edge(struct check *check, int32_t a, int32_t b)
{
    int64_t e = topology_find_edge(check->t, a, b);
    const struct face_edge *edge = e < 0 ? NULL : &check->t->edges[e];
    if (a == b || !edge)
        return a == b ? &repeated_vertex : &no_edge;
    if (topology_side_count(edge) != 1)
        return &inner_edge;
    if ((edge->up_count == 1) != (a < b))
        return &wrong_direction;
    if (check->passed[e])
        return &repeated_edge;
    check->passed[e] = true;
    check->passed_count++;
    return NULL;
}

static void reject_step(const struct fault *fault, int64_t loop, bool is_last, int32_t a, int32_t b,
                        struct judgement *out)
{
    judge_name_one(out, loop_noun, "%" PRId64 ", (%d,%d)", loop, a, b);
    judge_reject_for(out, &fault->cause);
    judge_en(out, "loop %" PRId64 " goes %sfrom %d to %d%s", loop, is_last ? "back " : "", a, b,
             fault->says.en);
    judge_es(out, "el bucle %" PRId64 " %s de %d a %d%s", loop, is_last ? "vuelve" : "va", a, b,
             fault->says.es);
    if (a == b)
        scene_mark_vertex(&out->scene, MARK_WRONG, a);
    else
        scene_mark_arrow(&out->scene, MARK_WRONG, a, b);
}

/* Follows a loop up to its first wrong step. Returns whether all are right. */
static bool follow_loop(struct check *check, int64_t loop, struct judgement *out)
{
    const int32_t *vertices = loop_vertices(check, loop);
    int64_t length = loop_length(check, loop);
    for (int64_t i = 0; i < length; i++) {
        bool is_last = i + 1 == length;
        int32_t a = vertices[i], b = vertices[is_last ? 0 : i + 1];
        const struct fault *fault = pass_edge(check, a, b);
        if (fault) {
            reject_step(fault, loop, is_last, a, b, out);
            return false;
        }
    }
    if (length == 0) {
        judge_name_one(out, loop_noun, "%" PRId64, loop);
        judge_reject(out, &empty_loop, "loop %" PRId64 " has no vertex.",
                     "el bucle %" PRId64 " no tiene ningún vértice.", loop);
    }
    return length > 0;
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
    judge_en(out, " Left out: %" PRId64 " of %" PRId64 " boundary edges.", missing, all);
    judge_es(out, " Omitidas: %" PRId64 " de %" PRId64 " aristas de borde.", missing, all);
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
    struct check check = {&t, &task->answer.table[0], calloc((size_t)t.edge_count + 1, 1), 0};
    int failed = check.passed ? 0 : error_set(err, "out of memory");
    bool right = !failed;
    for (int64_t l = 0; right && l < check.loops->row_count; l++)
        right = follow_loop(&check, l, out);
    if (right && check.passed_count == t.boundary.count)
        judge_accept(out);
    else if (right)
        reject_missing(&check, out);
    if (!failed && !out->accepted)
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
