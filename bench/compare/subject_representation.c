/* One representation with its operations, to be measured; see subjects.h.
 *
 * Queries ask about a sample of elements, the same for every representation: fewer where the
 * structure must search, so that a call stays short; the fact `queries` says how many. */
#include "bench/compare/answers.h"
#include "bench/compare/names.h"
#include "bench/compare/subject.h"

#include "reference/base/random.h"
#include "reference/representation/representation.h"

#include <stdlib.h>
#include <string.h>

enum {
    QUERIES_MAX = 4096,
    QUERIES_MIN = 2,
    QUERIES_COMPARED = 64, /* at most, whose answers are held against other representations' */
    COMPARED_BUDGET = 1000000,
    SEARCH_BUDGET = 400000 /* elements that the searches of one call look at */
};

struct query_sample {
    int count;
    int32_t vertices[QUERIES_MAX], others[QUERIES_MAX], faces[QUERIES_MAX];
};

struct held {
    const struct representation *kind;
    const struct snapshot *snapshot;
    void *self;     /* of the mesh as it is */
    void *moved;    /* another, for operations that change positions; made when needed */
    void *fresh;    /* struct_bytes for `build` */
    float *normals; /* of faces or vertices */
    int32_t *pairs; /* edges */
    int32_t *loop_vertices, *loop_starts;
    int32_t *ring; /* of the vertex with the highest valence */
    int32_t ring_capacity;
    struct query_sample sample;
    struct names names; /* made when an answer is asked for */
    int64_t result;     /* of the last operation */
    double area;
};

/* ---- operations that work on everything ---- */

static int run_build(void *context, struct error *err)
{
    struct held *held = context;
    return held->kind->build(held->fresh, &held->snapshot->mesh, err);
}

static void reset_build(void *context)
{
    struct held *held = context;
    held->kind->release(held->fresh);
}

static int answer_build(void *context, struct worker_answer *answer, struct error *err)
{
    struct held *held = context;
    const struct snapshot *snapshot = held->snapshot;
    struct mesh_counts counts = {.vertices = snapshot->mesh.vertex_count,
                                 .edges = snapshot->edge_count,
                                 .triangles = snapshot->mesh.triangle_count,
                                 .boundary_edges = snapshot->boundary_edge_count};
    struct mesh mesh = {0};
    if (held->kind->count_strips)
        held->kind->count_strips(held->fresh, &counts);
    if (held->kind->to_mesh(held->fresh, &mesh, err) != 0)
        return -1;
    answer_count(answer, mesh.triangle_count);
    mesh_release(&mesh);
    worker_fact(answer, "bytes", (double)held->kind->bytes(held->fresh));
    worker_fact(answer, "formula_bytes", (double)held->kind->formula_bytes(&counts));
    if (held->kind->count_strips) {
        worker_fact(answer, "strips", (double)counts.strips);
        worker_fact(answer, "strip_vertices", (double)counts.strip_vertices);
    }
    return 0;
}

/* A turn by 3/5, 4/5 around z, with a step: points stay about where they are, however often. */
static const float turn[12] = {0.6F, -0.8F, 0, 0.01F, 0.8F, 0.6F, 0, -0.01F, 0, 0, 1, 0};

static int need_names(struct held *held, struct error *err)
{
    return held->names.points ? 0 : names_of(&held->names, held->kind, held->self, err);
}

static int need_moved(struct held *held, struct error *err)
{
    return held->moved ? 0
                       : representation_new(held->kind, &held->moved, &held->snapshot->mesh, err);
}

static int run_transform(void *context, struct error *err)
{
    struct held *held = context;
    if (need_moved(held, err) != 0)
        return -1;
    held->result = held->kind->transform(held->moved, turn);
    return 0;
}

static int run_smooth(void *context, struct error *err)
{
    struct held *held = context;
    return need_moved(held, err) == 0 ? held->kind->smooth(held->moved, err) : -1;
}

/* Positions after one step from the mesh as it was: `moved` has seen many. */
static int answer_moved(struct held *held, bool smooth, struct worker_answer *answer,
                        struct error *err)
{
    struct mesh mesh = {0};
    void *self = NULL;
    int result = need_names(held, err);
    if (result == 0)
        result = representation_new(held->kind, &self, &held->snapshot->mesh, err);
    if (result == 0 && smooth)
        result = held->kind->smooth(self, err);
    else if (result == 0)
        held->kind->transform(self, turn);
    if (result == 0)
        result = held->kind->to_mesh(self, &mesh, err);
    if (result == 0)
        answer_vectors_named(answer, mesh.positions, mesh.vertex_count, held->names.points);
    mesh_release(&mesh);
    representation_delete(held->kind, self);
    return result;
}

static int answer_transform(void *context, struct worker_answer *answer, struct error *err)
{
    struct held *held = context;
    worker_fact(answer, "vertices_processed", (double)held->result);
    return answer_moved(held, false, answer, err);
}

static int answer_smooth(void *context, struct worker_answer *answer, struct error *err)
{
    return answer_moved(context, true, answer, err);
}

static int run_area(void *context, struct error *err)
{
    struct held *held = context;
    (void)err;
    held->area = held->kind->area(held->self);
    return 0;
}

static int answer_area_of(void *context, struct worker_answer *answer, struct error *err)
{
    (void)err;
    answer_area(answer, ((struct held *)context)->area);
    return 0;
}

static int run_face_normals(void *context, struct error *err)
{
    struct held *held = context;
    (void)err;
    held->kind->face_normals(held->self, held->normals);
    return 0;
}

static int run_vertex_normals(void *context, struct error *err)
{
    struct held *held = context;
    return held->kind->vertex_normals(held->self, held->normals, err);
}

static int answer_face_normals(void *context, struct worker_answer *answer, struct error *err)
{
    struct held *held = context;
    if (need_names(held, err) != 0)
        return -1;
    answer_vectors_named(answer, held->normals, held->names.face_count, held->names.faces);
    return 0;
}

/* Of each vertex once, where they are not shared too. */
static int answer_vertex_normals(void *context, struct worker_answer *answer, struct error *err)
{
    struct held *held = context;
    if (need_names(held, err) != 0)
        return -1;
    const struct names *names = &held->names;
    float *normals = malloc(12 * (size_t)names->mesh.vertex_count + 1);
    if (!normals)
        return error_set(err, "out of memory: normals");
    for (int32_t v = 0; v < names->mesh.vertex_count; v++)
        memcpy(normals + 3 * (int64_t)v, held->normals + 3 * (int64_t)names->numbers[v], 12);
    answer_vectors_named(answer, normals, names->mesh.vertex_count, names->points);
    free(normals);
    return 0;
}

static int run_edges(void *context, struct error *err)
{
    struct held *held = context;
    held->result = held->kind->edges(held->self, held->pairs, err);
    return held->result < 0 ? -1 : 0;
}

static int answer_edge_list(void *context, struct worker_answer *answer, struct error *err)
{
    struct held *held = context;
    if (need_names(held, err) != 0)
        return -1;
    answer_edges_named(answer, held->pairs, held->result, held->names.vertices);
    return 0;
}

static int run_loops(void *context, struct error *err)
{
    struct held *held = context;
    held->result =
        held->kind->boundary_loops(held->self, held->loop_vertices, held->loop_starts, err);
    return held->result < 0 ? -1 : 0;
}

static int answer_loops(void *context, struct worker_answer *answer, struct error *err)
{
    struct held *held = context;
    (void)err;
    answer_count(answer, held->loop_starts[held->result]);
    worker_fact(answer, "boundary_loops", (double)held->result);
    return 0;
}

/* ---- queries about single elements ---- */

struct question {
    struct held *held;
    enum query query;
};

static int ask_one(const struct held *held, enum query query, int i)
{
    const struct representation *kind = held->kind;
    const struct query_sample *sample = &held->sample;
    int32_t neighbours[3];
    switch (query) {
    case QUERY_FACE_NEIGHBOURS:
        return kind->face_neighbours(held->self, sample->faces[i], neighbours);
    case QUERY_FACES_AROUND_VERTEX:
        return kind->faces_around_vertex(held->self, sample->vertices[i], held->ring,
                                         held->ring_capacity);
    case QUERY_VERTICES_AROUND_VERTEX:
        return kind->vertices_around_vertex(held->self, sample->vertices[i], held->ring,
                                            held->ring_capacity);
    case QUERY_IS_EDGE:
        return kind->is_edge(held->self, sample->vertices[i], sample->others[i]);
    case QUERY_FACE_VERTICES:
    case QUERY_COUNT:
        break;
    }
    return 0;
}

static int query_count(const struct held *held, enum query query)
{
    if (strcmp(held->kind->cost[query], "n") != 0)
        return held->sample.count;
    int64_t fits = SEARCH_BUDGET / ((int64_t)held->snapshot->mesh.triangle_count + 1);
    fits = fits < QUERIES_MIN ? QUERIES_MIN : fits;
    return (int)(fits < held->sample.count ? fits : held->sample.count);
}

static int64_t ask_many(const struct held *held, enum query query, int count)
{
    int64_t sum = 0;
    for (int i = 0; i < count; i++)
        sum += ask_one(held, query, i);
    return sum;
}

static int run_question(void *context, struct error *err)
{
    const struct question *question = context;
    struct held *held = question->held;
    (void)err;
    held->result = ask_many(held, question->query, query_count(held, question->query));
    return 0;
}

/* The same for every representation of a mesh. */
static int compared_count(const struct held *held)
{
    int64_t fits = COMPARED_BUDGET / ((int64_t)held->snapshot->mesh.triangle_count + 1) + 1;
    fits = fits < QUERIES_COMPARED ? fits : QUERIES_COMPARED;
    return (int)(fits < held->sample.count ? fits : held->sample.count);
}

/* The neighbours of a face, each with the edge to it. */
static uint64_t neighbours_hash(const struct held *held, int32_t face)
{
    const int32_t *corners = held->names.mesh.triangles + 3 * (int64_t)face;
    int32_t neighbours[3];
    uint64_t sum = 0;
    held->kind->face_neighbours(held->self, face, neighbours);
    for (int side = 0; side < 3; side++) {
        uint64_t from = held->names.points[corners[side]];
        uint64_t to = held->names.points[corners[(side + 1) % 3]];
        uint64_t other = neighbours[side] < 0 ? 0 : held->names.faces[neighbours[side]];
        sum += answer_mix(answer_mix(answer_mix(from) + to) + other);
    }
    return sum;
}

/* What stands around a vertex, in any order. */
static uint64_t ring_hash(const struct held *held, enum query query, int32_t vertex)
{
    bool of_faces = query == QUERY_FACES_AROUND_VERTEX;
    const uint64_t *names = of_faces ? held->names.faces : held->names.vertices;
    int32_t count =
        (of_faces ? held->kind->faces_around_vertex : held->kind->vertices_around_vertex)(
            held->self, vertex, held->ring, held->ring_capacity);
    uint64_t sum = answer_mix((uint64_t)count);
    for (int32_t i = 0; i < count && i < held->ring_capacity; i++)
        sum += answer_mix(names[held->ring[i]]);
    return sum;
}

/* The answer to one question about the same element in every representation. */
static uint64_t question_hash(const struct held *held, enum query query, int i)
{
    const struct mesh *mesh = &held->snapshot->mesh;
    const struct query_sample *sample = &held->sample;
    if (query == QUERY_FACE_NEIGHBOURS) {
        int32_t face = names_face(&held->names, names_triangle(mesh, sample->faces[i]));
        return face < 0 ? 0 : neighbours_hash(held, face);
    }
    const int32_t asked[2] = {sample->vertices[i], sample->others[i]};
    int32_t here[2];
    for (int k = 0; k < 2; k++)
        here[k] = names_vertex(&held->names,
                               answer_position_name(mesh->positions + 3 * (int64_t)asked[k]));
    if (here[0] < 0 || here[1] < 0) /* only triangles are kept, and it is in none */
        return 0;
    return query == QUERY_IS_EDGE ? held->kind->is_edge(held->self, here[0], here[1])
                                  : ring_hash(held, query, here[0]);
}

static int answer_question(void *context, struct worker_answer *answer, struct error *err)
{
    const struct question *question = context;
    struct held *held = question->held;
    if (need_names(held, err) != 0)
        return -1;
    int count = compared_count(held);
    uint64_t hash = 0;
    for (int i = 0; i < count; i++)
        hash = answer_mix(hash + question_hash(held, question->query, i));
    answer->hash = hash | 1;
    worker_fact(answer, "queries", query_count(held, question->query));
    return 0;
}

/* The same elements for every representation of the mesh. Half of the pairs are edges. */
static void make_sample(struct held *held)
{
    const struct mesh *mesh = &held->snapshot->mesh;
    struct query_sample *sample = &held->sample;
    struct random rng;
    random_init(&rng, 1);
    for (int i = 0; i < QUERIES_MAX && mesh->triangle_count > 0; i++) {
        sample->faces[i] = (int32_t)random_below(&rng, (uint64_t)mesh->triangle_count);
        const int32_t *corners = mesh->triangles + 3 * (int64_t)sample->faces[i];
        sample->vertices[i] = corners[i % 3];
        sample->others[i] = i % 2 ? corners[(i + 1) % 3]
                                  : (int32_t)random_below(&rng, (uint64_t)mesh->vertex_count);
        sample->count++;
    }
}

/* ---- the worker ---- */

static int take_memory(struct held *held, struct worker_memory *memory, struct error *err)
{
    const struct representation *kind = held->kind;
    int64_t vertices = kind->vertex_count(held->self), faces = kind->face_count(held->self);
    int64_t most = vertices > faces ? vertices : faces;
    size_t boundary = (size_t)held->snapshot->boundary_edge_count;
    held->ring_capacity = (int32_t)held->snapshot->highest_valence + 1;
    held->normals = worker_memory_take(memory, 12 * (size_t)most, err);
    held->pairs = worker_memory_take(memory, 24 * (size_t)faces, err);
    held->loop_vertices = worker_memory_take(memory, 4 * boundary, err);
    held->loop_starts = worker_memory_take(memory, 4 * (boundary + 1), err);
    held->ring = worker_memory_take(memory, 4 * (size_t)held->ring_capacity, err);
    held->fresh = calloc(1, kind->struct_bytes);
    return held->normals && held->pairs && held->loop_vertices && held->loop_starts && held->ring &&
                   held->fresh
               ? 0
               : error_set(err, "out of memory");
}

static int serve_held(struct held *held, struct worker_memory *memory, FILE *in, FILE *out,
                      struct error *err)
{
    struct question faces_around = {held, QUERY_FACES_AROUND_VERTEX};
    struct question vertices_around = {held, QUERY_VERTICES_AROUND_VERTEX};
    struct question neighbours = {held, QUERY_FACE_NEIGHBOURS}, is_edge = {held, QUERY_IS_EDGE};
    const struct worker_operation operations[] = {
        {"build", held, run_build, reset_build, answer_build},
        {"transform", held, run_transform, NULL, answer_transform},
        {"area", held, run_area, NULL, answer_area_of},
        {"face-normals", held, run_face_normals, NULL, answer_face_normals},
        {"vertex-normals", held, run_vertex_normals, NULL, answer_vertex_normals},
        {"edges", held, run_edges, NULL, answer_edge_list},
        {"boundary-loops", held, run_loops, NULL, answer_loops},
        {"faces-around-vertex", &faces_around, run_question, NULL, answer_question},
        {"vertices-around-vertex", &vertices_around, run_question, NULL, answer_question},
        {"face-neighbours", &neighbours, run_question, NULL, answer_question},
        {"is-edge", &is_edge, run_question, NULL, answer_question},
        {"smooth", held, run_smooth, NULL, answer_smooth}};
    struct worker_subject subject = {.operations = operations,
                                     .operation_count = sizeof operations / sizeof *operations,
                                     .thread_count = 1,
                                     .memory = memory};
    return worker_serve(&subject, in, out, err);
}

int subject_serve_representation(const char *name, const struct snapshot *snapshot, FILE *in,
                                 FILE *out, struct error *err)
{
    struct held held = {.kind = representation_find(name), .snapshot = snapshot};
    struct worker_memory memory = {.piece_count = 0};
    struct error refusal = {""};
    if (!held.kind)
        return error_set(err, "there is no representation \"%.60s\"", name);
    if (representation_new(held.kind, &held.self, &snapshot->mesh, &refusal) != 0) {
        worker_refuse(out, refusal.text);
        return 0;
    }
    make_sample(&held);
    int result = take_memory(&held, &memory, err);
    if (result == 0)
        result = serve_held(&held, &memory, in, out, err);
    representation_delete(held.kind, held.self);
    representation_delete(held.kind, held.moved);
    names_release(&held.names);
    free(held.fresh);
    worker_memory_release(&memory);
    return result;
}
