/* Accesses of queries, counted; see accesses.h. */
#include "bench/compare/accesses.h"

#include "bench/compare/counted_reads.h"
#include "reference/mesh/generate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLE_MAX = 16, LOW_VALENCE = 4 };

/* -- queries ---------------------------------------------------------------------------------- */

const char *query_name(enum query query)
{
    static const char *const names[QUERY_COUNT] = {
        [QUERY_FACE_VERTICES] = "face-vertices",
        [QUERY_FACE_NEIGHBOURS] = "face-neighbours",
        [QUERY_FACES_AROUND_VERTEX] = "faces-around-vertex",
        [QUERY_VERTICES_AROUND_VERTEX] = "vertices-around-vertex",
        [QUERY_IS_EDGE] = "is-edge"};
    return names[query];
}

static bool is_about_face(enum query query)
{
    return query == QUERY_FACE_VERTICES || query == QUERY_FACE_NEIGHBOURS;
}

/* Elements to ask about: faces, and vertices with another one that shares no edge with it. */
struct sample {
    int32_t faces[SAMPLE_MAX], vertices[SAMPLE_MAX], others[SAMPLE_MAX];
    int count;
};

/* One query about element i of the sample. Returns its accesses, or -1 without memory. */
static int64_t count_query(const struct representation *kind, const void *self, enum query query,
                           const struct sample *sample, int i)
{
    int32_t corners[3], found = 0;
    counted_reads_begin(kind, self);
    if (query == QUERY_FACE_VERTICES)
        kind->face_vertices(self, sample->faces[i], 1, corners);
    else if (query == QUERY_FACE_NEIGHBOURS)
        (void)kind->face_neighbours(self, sample->faces[i], corners);
    else if (query == QUERY_FACES_AROUND_VERTEX)
        (void)kind->faces_around_vertex(self, sample->vertices[i], NULL, 0);
    else if (query == QUERY_VERTICES_AROUND_VERTEX)
        found = kind->vertices_around_vertex(self, sample->vertices[i], NULL, 0);
    else
        (void)kind->is_edge(self, sample->vertices[i], sample->others[i]);
    int64_t accesses = counted_reads_end();
    return found < 0 ? -1 : accesses;
}

/* Mean accesses of the query over the sample. */
static int count_sample(const struct representation *kind, const void *self, enum query query,
                        const struct sample *sample, double *mean, struct error *err)
{
    double sum = 0.0;
    for (int i = 0; i < sample->count; i++) {
        int64_t accesses = count_query(kind, self, query, sample, i);
        if (accesses < 0)
            return error_set(err, "out of memory: a query of %s", kind->name);
        sum += (double)accesses;
    }
    *mean = sum / sample->count;
    return 0;
}

/* -- choosing elements, by the mesh that the structure gives back -------------------------------
 */

/* The first face in which the two vertices follow each other, or -1. */
static int32_t face_with_side(const struct mesh *mesh, int32_t from, int32_t to)
{
    for (int32_t f = 0; f < mesh->triangle_count; f++)
        for (int i = 0; i < 3; i++)
            if (mesh->triangles[3 * f + i] == from && mesh->triangles[3 * f + (i + 1) % 3] == to)
                return f;
    return -1;
}

/* A vertex that shares no edge with this one, of the same valence; the search starts at `from`. */
static int32_t find_stranger(const struct mesh *mesh, const int32_t *valences, int32_t vertex,
                             int32_t from)
{
    int32_t other = from % mesh->vertex_count;
    while (other == vertex || valences[other] != valences[vertex] ||
           face_with_side(mesh, vertex, other) >= 0 || face_with_side(mesh, other, vertex) >= 0)
        other = (other + 1) % mesh->vertex_count;
    return other;
}

/* Faces and vertices from the whole mesh. */
static void sample_evenly(const struct mesh *mesh, const int32_t *valences, struct sample *sample)
{
    sample->count = SAMPLE_MAX;
    for (int i = 0; i < SAMPLE_MAX; i++) {
        int32_t vertex = (int32_t)((int64_t)mesh->vertex_count * i / SAMPLE_MAX);
        sample->faces[i] = (int32_t)((int64_t)mesh->triangle_count * i / SAMPLE_MAX);
        sample->vertices[i] = vertex;
        sample->others[i] = find_stranger(mesh, valences, vertex, vertex + mesh->vertex_count / 2);
    }
}

static const int32_t vertex_valences[2] = {LOW_VALENCE, ACCESS_VALENCE};

/* The first vertex of the step's valence and a stranger to it; of a bipyramid there are two at
 * least.
 */
static void sample_vertex(const struct mesh *mesh, const int32_t *valences, int step,
                          struct sample *sample)
{
    int32_t vertex = 0;
    while (valences[vertex] != vertex_valences[step])
        vertex++;
    sample->count = 1;
    sample->vertices[0] = vertex;
    sample->others[0] = find_stranger(mesh, valences, vertex, vertex + 1);
}

/* The first face with one corner of high valence, then the first with two: a flipped bipyramid has
 * both. */
static void sample_face(const struct mesh *mesh, const int32_t *valences, int step,
                        struct sample *sample)
{
    int32_t face = -1;
    int high;
    do {
        face++;
        high = 0;
        for (int i = 0; i < 3; i++)
            high += valences[mesh->triangles[3 * face + i]] >= ACCESS_VALENCE;
    } while (high != 1 + step);
    sample->count = 1;
    sample->faces[0] = face;
}

/* -- a structure with its mesh ------------------------------------------------------------------
 */

struct subject {
    const struct representation *kind;
    void *self;
    struct mesh mesh;  /* that to_mesh gives */
    int32_t *valences; /* triangles of each vertex of it */
    int32_t *names;    /* how the structure calls the vertices of the mesh */
};

static void subject_release(struct subject *subject)
{
    representation_delete(subject->kind, subject->self);
    mesh_release(&subject->mesh);
    free(subject->valences);
    free(subject->names);
}

static int subject_make(struct subject *subject, const struct representation *kind,
                        const struct mesh *mesh, struct error *err)
{
    *subject = (struct subject){.kind = kind};
    if (representation_new(kind, &subject->self, mesh, err) != 0)
        return -1;
    int result = kind->to_mesh(subject->self, &subject->mesh, err);
    size_t vertices = (size_t)subject->mesh.vertex_count;
    if (result == 0) {
        subject->valences = calloc(vertices + 1, sizeof *subject->valences);
        subject->names = malloc((vertices + 1) * sizeof *subject->names);
        if (!subject->valences || !subject->names)
            result = error_set(err, "out of memory: %zu vertices", vertices);
    }
    for (size_t v = 0; result == 0 && v < vertices; v++)
        subject->names[v] = (int32_t)v;
    if (result == 0 && kind->vertex_names)
        result = kind->vertex_names(subject->self, &subject->mesh, subject->names, err);
    for (int64_t c = 0; result == 0 && c < 3 * (int64_t)subject->mesh.triangle_count; c++)
        subject->valences[subject->mesh.triangles[c]]++;
    if (result != 0)
        subject_release(subject);
    return result;
}

/* Asks each query about the elements, whose vertices are numbered as in the mesh. */
static int ask(const struct subject *subject, struct sample sample, enum query first,
               enum query last, double means[QUERY_COUNT], struct error *err)
{
    for (int i = 0; i < sample.count; i++) {
        sample.vertices[i] = subject->names[sample.vertices[i]];
        sample.others[i] = subject->names[sample.others[i]];
    }
    for (int query = (int)first; query <= (int)last; query++)
        if (count_sample(subject->kind, subject->self, (enum query)query, &sample, &means[query],
                         err) != 0)
            return -1;
    return 0;
}

/* -- the meshes ---------------------------------------------------------------------------------
 */

enum { SMALL_TORUS, LARGE_TORUS, BIPYRAMID, FLIPPED, MESHES };

/* Turns the ring edge between triangle 0 = (p,a,b) and triangle `valence` = (q,b,a) of a bipyramid
 * into an edge between the apexes p and q. */
static void flip_ring_edge(struct mesh *mesh)
{
    int32_t *above = mesh->triangles, *below = above + 3 * ACCESS_VALENCE;
    int32_t p = above[0], b = above[2], q = below[0];
    above[2] = q; /* p a q */
    below[1] = b; /* q b p */
    below[2] = p;
}

static int make_meshes(struct mesh meshes[MESHES], struct error *err)
{
    if (generate_torus(&meshes[SMALL_TORUS], 1, ACCESS_SMALL, err) != 0 ||
        generate_torus(&meshes[LARGE_TORUS], 1, ACCESS_LARGE, err) != 0 ||
        generate_bipyramid(&meshes[BIPYRAMID], ACCESS_VALENCE, err) != 0 ||
        generate_bipyramid(&meshes[FLIPPED], ACCESS_VALENCE, err) != 0)
        return -1;
    flip_ring_edge(&meshes[FLIPPED]);
    return 0;
}

/* -- counting -----------------------------------------------------------------------------------
 */

struct means {
    double by_size[2][QUERY_COUNT], by_valence[2][QUERY_COUNT];
};

static int ask_torus(const struct representation *kind, const struct mesh *mesh,
                     double means[QUERY_COUNT], struct error *err)
{
    struct subject subject;
    struct sample sample = {.count = 0};
    if (subject_make(&subject, kind, mesh, err) != 0)
        return -1;
    sample_evenly(&subject.mesh, subject.valences, &sample);
    int result = ask(&subject, sample, QUERY_FACE_VERTICES, QUERY_IS_EDGE, means, err);
    subject_release(&subject);
    return result;
}

typedef void sample_fn(const struct mesh *mesh, const int32_t *valences, int step,
                       struct sample *sample);

/* Two steps of valence on the same mesh: the queries from `first` to `last` about what `choose`
 * takes at each. */
static int ask_valences(const struct representation *kind, const struct mesh *mesh,
                        sample_fn *choose, enum query first, enum query last, struct means *means,
                        struct error *err)
{
    struct subject subject;
    if (subject_make(&subject, kind, mesh, err) != 0)
        return -1;
    int result = 0;
    for (int step = 0; step < 2 && result == 0; step++) {
        struct sample sample = {.count = 0};
        choose(&subject.mesh, subject.valences, step, &sample);
        result = ask(&subject, sample, first, last, means->by_valence[step], err);
    }
    subject_release(&subject);
    return result;
}

/* What the counts grow with: between sizes some four times as large, n makes four times as many,
 * and a search among strips some more; between valences 64 times as large, k makes 64 times as
 * many. */
static const char *growth_of(const double by_size[2], const double by_valence[2])
{
    double with_size = log(by_size[1] / by_size[0]) / log(4.0);
    double with_valence = log(by_valence[1] / by_valence[0]) / log(64.0);
    if (with_size > 0.5)
        return "n";
    if (with_size > 0.1) /* below that, faces differ by that much from each other */
        return "lg s";
    return with_valence > 1.5 ? "k^2" : with_valence > 0.5 ? "k" : "1";
}

/* See accesses.h. */
static bool growth_is_claimed(const char *growth, const char *claimed, enum query query)
{
    if (strcmp(growth, claimed) == 0)
        return true;
    if (strcmp(claimed, "k") == 0)
        return is_about_face(query) && strcmp(growth, "1") == 0;
    if (strcmp(claimed, "lg s") == 0)
        return strcmp(growth, "1") == 0;
    return strcmp(claimed, "k^2") == 0 && strcmp(growth, "k") == 0;
}

static int count_kind(const struct representation *kind, const struct mesh meshes[MESHES],
                      struct access_count *rows, struct error *err)
{
    struct means means = {.by_size = {{0.0}}};
    if (ask_torus(kind, &meshes[SMALL_TORUS], means.by_size[0], err) != 0 ||
        ask_torus(kind, &meshes[LARGE_TORUS], means.by_size[1], err) != 0 ||
        ask_valences(kind, &meshes[BIPYRAMID], sample_vertex, QUERY_FACES_AROUND_VERTEX,
                     QUERY_IS_EDGE, &means, err) != 0 ||
        ask_valences(kind, &meshes[FLIPPED], sample_face, QUERY_FACE_VERTICES,
                     QUERY_FACE_NEIGHBOURS, &means, err) != 0)
        return -1;
    for (int query = 0; query < QUERY_COUNT; query++) {
        struct access_count *row = rows + query;
        *row = (struct access_count){.kind = kind, .query = (enum query)query};
        for (int i = 0; i < 2; i++) {
            row->by_size[i] = means.by_size[i][query];
            row->by_valence[i] = means.by_valence[i][query];
        }
        row->growth = growth_of(row->by_size, row->by_valence);
        row->holds = growth_is_claimed(row->growth, kind->cost[query], row->query);
    }
    return 0;
}

/* -- the whole ----------------------------------------------------------------------------------
 */

int accesses_count(struct access_counts *counts, struct error *err)
{
    struct mesh meshes[MESHES] = {{.positions = NULL}};
    int kinds = 0, result = make_meshes(meshes, err);
    while (counted_representation_table[kinds])
        kinds++;
    *counts = (struct access_counts){.valences = {vertex_valences[0], vertex_valences[1]}};
    for (int i = 0; i < 2; i++)
        counts->triangles[i] = meshes[SMALL_TORUS + i].triangle_count;
    counts->rows = calloc((size_t)kinds * QUERY_COUNT + 1, sizeof *counts->rows);
    if (result == 0 && !counts->rows)
        result = error_set(err, "out of memory: accesses of %d representations", kinds);
    for (int i = 0; i < kinds && result == 0; i++) {
        result =
            count_kind(counted_representation_table[i], meshes, counts->rows + counts->count, err);
        counts->count += result == 0 ? QUERY_COUNT : 0;
    }
    for (int i = 0; i < MESHES; i++)
        mesh_release(&meshes[i]);
    return result;
}

void accesses_release(struct access_counts *counts)
{
    free(counts->rows);
    *counts = (struct access_counts){0};
}

json_t *accesses_to_json(const struct access_counts *counts)
{
    json_t *rows = json_array();
    for (int i = 0; rows && i < counts->count; i++) {
        const struct access_count *row = counts->rows + i;
        json_t *json = json_pack("{s:s, s:s, s:s, s:s, s:s, s:b, s:[{s:i, s:f}, {s:i, s:f}], "
                                 "s:[{s:i, s:f}, {s:i, s:f}]}",
                                 "subject", row->kind->name, "title", row->kind->title, "query",
                                 query_name(row->query), "claim", row->kind->cost[row->query],
                                 "growth", row->growth, "holds", row->holds, "by_size", "triangles",
                                 counts->triangles[0], "accesses", row->by_size[0], "triangles",
                                 counts->triangles[1], "accesses", row->by_size[1], "by_valence",
                                 "valence", counts->valences[0], "accesses", row->by_valence[0],
                                 "valence", counts->valences[1], "accesses", row->by_valence[1]);
        if (!json || json_array_append_new(rows, json)) {
            json_decref(rows);
            return NULL;
        }
    }
    return rows;
}
