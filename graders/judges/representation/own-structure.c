/* Judges own-structure: every element is asked what touches it; neighbours.h judges what is listed.
 * A call measures either the building or the queries, and is judged the same. */
#include "graders/library/cases.h"
#include "graders/library/neighbours.h"

/* The numbers of a case: what is measured, and what is asked (the runner's). */
enum { BUILDING, ASKING };
enum { OF_VERTICES, OF_FACES };

/* clang-format off */
#define BOTH(name, class, seed, runs, kind, ...) \
    {"build-" name, class, seed, runs, .mesh = {__VA_ARGS__}, .number = {BUILDING, kind}}, \
    {"ask-" name, class, (seed) + 1, runs, .mesh = {__VA_ARGS__}, .number = {ASKING, kind}}
#define CASES_OF(noun, seed, kind) \
    BOTH("tetrahedron-" noun, noun, seed, PUBLIC | QUICK, kind, SHAPE_TETRAHEDRON), \
    BOTH("course-prism-" noun, noun, (seed) + 2, PUBLIC | QUICK, kind, SHAPE_COURSE_PRISM), \
    BOTH("icosphere-" noun, noun, (seed) + 4, QUICK, kind, SHAPE_ICO, .levels = 2, \
         .changes = SCRAMBLED), \
    BOTH("prism-40-" noun, noun, (seed) + 6, HIDDEN, kind, SHAPE_PRISM, .count = 40, \
         .changes = SCRAMBLED), \
    BOTH("quads-" noun, noun, (seed) + 8, HIDDEN, kind, SHAPE_QUAD_TORUS, .rows = 9, \
         .columns = 14, .changes = SCRAMBLED), \
    BOTH("bipyramid-40-" noun, noun, (seed) + 10, HIDDEN, kind, SHAPE_BIPYRAMID, .count = 40, \
         .changes = SCRAMBLED), \
    BOTH("bodies-" noun, noun, (seed) + 12, QUICK, kind, SHAPE_ICO, .levels = 1, \
         .changes = WITH_COMPONENTS | SCRAMBLED)
static const struct judge_case cases[] = {
    CASES_OF("faces-of-vertex", 1, OF_VERTICES), CASES_OF("faces-of-face", 21, OF_FACES),
};

static const struct size_family families[] = {
    {"build-sphere", FAMILY_SPHERE, SCRAMBLED, .has_number = true, .number = {BUILDING, OF_FACES}},
    {"build-quads", FAMILY_QUADS, SCRAMBLED, .has_number = true, .number = {BUILDING, OF_VERTICES}},
    {"ask-vertices", FAMILY_SPHERE, SCRAMBLED, .is_query = true, .has_number = true,
     .number = {ASKING, OF_VERTICES}},
    {"ask-faces", FAMILY_QUADS, SCRAMBLED, .is_query = true, .has_number = true,
     .number = {ASKING, OF_FACES}},
    {NULL}};

static const struct answer_rule answer = {
    .function = "run", .result = RESULT_COUNT, .counted = {"queries", "consultas"},
    .most = {.per_vertex = 1, .per_face = 1},
    .parts = {{.argument = "returned", .row = {"query", "consulta"}, .columns = 1, .rows = ROWS_RESULT},
              {.argument = "out", .row = {"query", "consulta"}, .columns = 1, .rows = ROWS_OF_ROWS,
               .most = {.once = 64, .per_corner = 40}}}};
/* clang-format on */

static enum neighbour_kind kind_of(const struct task *task)
{
    return task->number[1] == OF_VERTICES ? FACES_OF_VERTEX : FACES_OF_FACE;
}

static int32_t element_count(const struct task *task)
{
    return kind_of(task) == FACES_OF_VERTEX ? task->polygons.vertex_count
                                            : task->polygons.face_count;
}

/* The room that each answer has: more than twice the longest one. */
static int write_beside(const struct task *task, uint64_t seed, struct writer *beside,
                        struct error *err)
{
    struct winged_edge_mesh we;
    int32_t most = 0;
    (void)seed;
    if (neighbours_build(&task->polygons, &we, err))
        return -1;
    for (int32_t i = 0; i < element_count(task); i++) {
        int32_t count = neighbours_count(&we, kind_of(task), i);
        most = count > most ? count : most;
    }
    write_int(beside, 2 * most + 8);
    winged_edge_release(&we);
    return 0;
}

static int judge(const struct task *task, struct judgement *out, struct error *err)
{
    const struct answer_table *returned = &task->answer.table[0], *rows = &task->answer.table[1];
    static const struct cause unanswered = {
        "queries-unanswered", {"queries without an answer", "consultas sin respuesta"}};
    struct winged_edge_mesh we;
    struct reader beside = task->beside;
    int32_t capacity = (int32_t)read_int(&beside), count = element_count(task);
    if (neighbours_build(&task->polygons, &we, err))
        return -1;
    int failed = 0;
    if (rows->row_count != count)
        judge_reject(out, &unanswered, "%d of %d queries were answered.",
                     "Se contestaron %d de %d consultas.", (int)rows->row_count, count);
    for (int32_t i = 0; !out->cause[0] && !failed && i < count; i++) {
        const struct neighbour_asked asked = {.faces = &task->polygons,
                                              .we = &we,
                                              .kind = kind_of(task),
                                              .element = i,
                                              .capacity = capacity,
                                              .returned = answer_int(returned, i, 0),
                                              .listed =
                                                  (const int32_t *)rows->cells + rows->first[i],
                                              .listed_count = rows->first[i + 1] - rows->first[i]};
        failed = neighbours_judge(&asked, out, err);
    }
    winged_edge_release(&we);
    out->scene.ok_count = -1;
    if (failed)
        return -1;
    if (out->cause[0])
        return task_show(task, out, err);
    judge_accept(out);
    return 0;
}

const struct judge judge_own_structure = {
    .exercise = "own-structure",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .input = INPUT_POLYGONS,
    .families = families,
    .answer = &answer,
    .judge = judge,
    .write_beside = write_beside,
};
