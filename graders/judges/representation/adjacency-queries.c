/* Judges adjacency-queries. Beside the mesh stand its winged edges, which the student reads through
 * counted functions, and the queries of the case; neighbours.h judges what each lists. */
#include "graders/library/accesses.h"
#include "graders/library/cases.h"
#include "graders/library/neighbours.h"
#include "reference/base/random.h"
#include "reference/representation/winged_edge_queries.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

/* The first number of a case: an enum neighbour_kind, in the runner's order, or all of them. */
enum { ALL_KINDS = NEIGHBOUR_KINDS };
/* The second: of which elements. */
enum { OF_ALL, AROUND_ONE /* the vertex with most edges, an edge and the faces at it */ };

/* clang-format off */
#define EACH(name, class, seed, runs, kind, ...) \
    {name, class, seed, runs, .mesh = {__VA_ARGS__}, .number = {kind, OF_ALL}}
#define CASES_OF(noun, seed, kind) \
    EACH("tetrahedron-" noun, noun, seed, PUBLIC | QUICK, kind, SHAPE_TETRAHEDRON), \
    EACH("course-prism-" noun, noun, (seed) + 1, PUBLIC | QUICK, kind, SHAPE_COURSE_PRISM), \
    EACH("icosphere-" noun, noun, (seed) + 2, QUICK, kind, SHAPE_ICO, .levels = 2, \
         .changes = SCRAMBLED), \
    EACH("prism-40-" noun, noun, (seed) + 3, HIDDEN, kind, SHAPE_PRISM, .count = 40, \
         .changes = SCRAMBLED), \
    EACH("quads-" noun, noun, (seed) + 4, HIDDEN, kind, SHAPE_QUAD_TORUS, .rows = 9, \
         .columns = 14, .changes = SCRAMBLED), \
    {"bipyramid-40-" noun, noun, (seed) + 5, HIDDEN, \
     .mesh = {SHAPE_BIPYRAMID, .count = 40, .changes = SCRAMBLED}, .number = {kind, AROUND_ONE}}
#define COST_OF(noun, seed, kind) \
    EACH("cost-" noun, "costs", seed, PUBLIC, kind, SHAPE_ICO, .levels = 2, .changes = SCRAMBLED)
#define SHARP_COST_OF(noun, seed, kind) \
    EACH("cost-" noun, "costs-sharp", seed, PUBLIC, kind, SHAPE_PRISM, .count = 24, \
         .changes = SCRAMBLED)
static const struct judge_case cases[] = {
    CASES_OF("edges-of-face", 1, EDGES_OF_FACE), CASES_OF("vertices-of-face", 11, VERTICES_OF_FACE),
    CASES_OF("faces-of-face", 21, FACES_OF_FACE), CASES_OF("edges-of-vertex", 31, EDGES_OF_VERTEX),
    CASES_OF("faces-of-vertex", 41, FACES_OF_VERTEX),
    CASES_OF("vertices-of-vertex", 51, VERTICES_OF_VERTEX),
    CASES_OF("edges-of-edge", 61, EDGES_OF_EDGE),
    COST_OF("edges-of-face", 91, EDGES_OF_FACE), COST_OF("edges-of-vertex", 92, EDGES_OF_VERTEX),
    COST_OF("faces-of-vertex", 93, FACES_OF_VERTEX),
    COST_OF("vertices-of-vertex", 94, VERTICES_OF_VERTEX),
    COST_OF("edges-of-edge", 95, EDGES_OF_EDGE),
    SHARP_COST_OF("vertices-of-face", 101, VERTICES_OF_FACE),
    SHARP_COST_OF("faces-of-face", 102, FACES_OF_FACE),
};

static const struct size_family families[] = {
    {"all-of-sphere", FAMILY_SPHERE, SCRAMBLED, false, true, {ALL_KINDS, OF_ALL}},
    {"all-of-quads", FAMILY_QUADS, SCRAMBLED, false, true, {ALL_KINDS, OF_ALL}},
    {"one-apex", FAMILY_BIPYRAMID, SCRAMBLED, false, true, {ALL_KINDS, AROUND_ONE}}, {NULL}};

static const struct answer_rule answer = {
    .function = "run", .result = RESULT_COUNT, .counted = {"queries", "consultas"},
    .most = {.once = 8, .per_vertex = 3, .per_face = 3, .per_corner = 1},
    .parts = {{.argument = "returned", .row = {"query", "consulta"}, .columns = 1, .rows = ROWS_RESULT},
              {.argument = "out", .row = {"query", "consulta"}, .columns = 1, .rows = ROWS_OF_ROWS,
               .most = {.once = 64, .per_corner = 40}}}};
/* clang-format on */

/* A query of the packet. */
struct asked {
    int32_t kind, element, capacity;
};

/* ------------------------------------------------------------------------------------- inputs */

static void write_structure(const struct winged_edge_mesh *we, struct writer *beside)
{
    write_int(beside, we->edge_count);
    for (int32_t e = 0; e < we->edge_count; e++) {
        const struct winged_edge *row = &we->edges[e];
        const int32_t columns[8] = {row->vertex[0],   row->vertex[1],   row->face[0],
                                    row->face[1],     row->previous[0], row->next[0],
                                    row->previous[1], row->next[1]};
        write_array(beside, columns, 8, sizeof *columns);
    }
    write_array(beside, we->vertex_edge, we->vertex_count, sizeof *we->vertex_edge);
    write_array(beside, we->face_edge, we->face_count, sizeof *we->face_edge);
}

/* The vertex with most edges, the first of these. */
static int32_t find_apex(const struct winged_edge_mesh *we)
{
    int32_t apex = 0, most = 0;
    for (int32_t v = 0; v < we->vertex_count; v++) {
        int32_t count = winged_edge_edges_of_vertex(we, v, NULL, 0);
        if (count > most)
            apex = v;
        most = count > most ? count : most;
    }
    return apex;
}

/* Queries that are being collected. */
struct list {
    struct asked *queries;
    int64_t count, room;
    struct random rng;
};

static void ask(struct list *list, const struct winged_edge_mesh *we, int kind, int32_t element)
{
    int32_t count = neighbours_count(we, kind, element);
    int32_t capacity = 2 * count + 4 + (int32_t)random_below(&list->rng, 8); /* tells nothing */
    list->room += capacity;
    list->queries[list->count++] = (struct asked){kind, element, capacity};
}

static void ask_kind(struct list *list, const struct winged_edge_mesh *we, int kind, bool all)
{
    const int32_t counts[] = {we->face_count, we->vertex_count, we->edge_count};
    enum neighbour_element of = neighbour_queries[kind].of;
    int32_t apex = all ? 0 : find_apex(we), count = all ? counts[of] : 1;
    const struct winged_side spoke = winged_edge_of_vertex(we, apex);
    if (!all && of == AT_FACE)
        count = winged_edge_faces_of_vertex(we, apex, NULL, 0);
    struct winged_side side = spoke;
    for (int32_t i = 0; i < count; i++) {
        ask(list, we, kind,
            all               ? i
            : of == AT_VERTEX ? apex
            : of == AT_EDGE   ? spoke.edge
                              : winged_edge_face(we, side));
        side = winged_edge_turn_left(we, side);
    }
}

static int write_beside(const struct task *task, uint64_t seed, struct writer *beside,
                        struct error *err)
{
    struct winged_edge_mesh we;
    if (neighbours_build(&task->polygons, &we, err))
        return -1;
    size_t most =
        3 * (size_t)we.face_count + 3 * (size_t)we.vertex_count + (size_t)we.edge_count + 1;
    struct list list = {.queries = calloc(most, sizeof *list.queries)};
    random_init(&list.rng, seed);
    int64_t kind = task->number[0], last = kind == ALL_KINDS ? NEIGHBOUR_KINDS - 1 : kind;
    for (kind = kind == ALL_KINDS ? 0 : kind; list.queries && kind <= last; kind++)
        ask_kind(&list, &we, (int)kind, task->number[1] == OF_ALL);
    write_structure(&we, beside);
    write_int(beside, list.count);
    write_int(beside, list.room);
    write_array(beside, list.queries, list.count, sizeof *list.queries);
    int failed = list.queries ? 0 : error_set(err, "out of memory for queries");
    free(list.queries);
    winged_edge_release(&we);
    return failed;
}

/* Reads what write_beside wrote, up to the queries. */
static const struct asked *read_asked(const struct task *task, const struct winged_edge_mesh *we,
                                      int64_t *count)
{
    struct reader beside = task->beside;
    int64_t edges = read_int(&beside);
    (void)read_array(&beside, edges, 8 * sizeof(int32_t));
    (void)read_array(&beside, we->vertex_count, sizeof(int32_t));
    (void)read_array(&beside, we->face_count, sizeof(int32_t));
    *count = read_int(&beside);
    (void)read_int(&beside);
    return read_array(&beside, *count, sizeof(struct asked));
}

/* ------------------------------------------------------------------------------------- judging */

/* All queries in turn, up to the first that is answered wrongly, which is shown. `listed` gets what there is to
 * list, `least` the accesses without which nobody can. */
static int judge_queries(const struct task *task, const struct winged_edge_mesh *we,
                         int64_t *listed, int64_t *least, struct judgement *out, struct error *err)
{
    static const struct cause unanswered = {
        "queries-unanswered", {"queries without an answer", "consultas sin respuesta"}};
    const struct answer_table *returned = &task->answer.table[0], *rows = &task->answer.table[1];
    int64_t count;
    const struct asked *asked = read_asked(task, we, &count);
    if (!asked || count != rows->row_count) {
        judge_reject(out, &unanswered, "%" PRId64 " of %" PRId64 " queries were answered.",
                     "Se contestaron %" PRId64 " de %" PRId64 " consultas.", rows->row_count,
                     count);
        return 0;
    }
    for (int64_t i = 0; !out->cause[0] && i < count; i++) {
        const struct asked *one = &asked[i];
        const struct neighbour_asked query = {.faces = &task->polygons,
                                              .we = we,
                                              .kind = (enum neighbour_kind)one->kind,
                                              .element = one->element,
                                              .capacity = one->capacity,
                                              .returned = answer_int(returned, i, 0),
                                              .listed =
                                                  (const int32_t *)rows->cells + rows->first[i],
                                              .listed_count = rows->first[i + 1] - rows->first[i]};
        *listed += neighbours_count(we, one->kind, one->element);
        *least += neighbours_least_accesses(we, one->kind, one->element);
        if (neighbours_judge(&query, out, err))
            return -1;
        if (i == count - 1 && !out->cause[0]) /* what is beyond a band shows one query */
            neighbours_show(&query, &out->scene);
    }
    return 0;
}

static int judge(const struct task *task, struct judgement *out, struct error *err)
{
    struct winged_edge_mesh we;
    int64_t listed = 0, least = 0;
    if (neighbours_build(&task->polygons, &we, err))
        return -1;
    int failed = judge_queries(task, &we, &listed, &least, out, err);
    winged_edge_release(&we);
    out->scene.ok_count = -1;
    if (failed)
        return -1;
    if (out->cause[0] || accesses_reject(task->usage, least, out))
        return task_show(task, out, err);
    judge_quality(out, (double)task->usage->access_count / (double)listed);
    judge_accept(out);
    return 0;
}

const struct judge judge_adjacency_queries = {
    .exercise = "adjacency-queries",
    .cases = cases,
    .case_count = sizeof cases / sizeof *cases,
    .input = INPUT_POLYGONS,
    .families = families,
    .answer = &answer,
    .judge = judge,
    .quality = {.name = {"accesses per element listed", "accesos por elemento hallado"},
                .less_is_better = true,
                .bands = {{"costs", 3, {"costs n", "coste n"}},
                          {"costs-sharp", 3, {"costs k", "coste k"}}}},
    .write_beside = write_beside,
};
