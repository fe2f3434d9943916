/* The course's claims about meshes and sweeps; see claims.h. */
#include "bench/compare/claims_rows.h"

#include "reference/base/random.h"
#include "reference/mesh/check.h"
#include "reference/representation/by_faces.h"

#include <math.h>
#include <stdlib.h>

/* -- rows ----------------------------------------------------------------------------------- */

int claims_add(struct claims *claims, const struct claim *row, const char *mesh, struct error *err)
{
    if (claims->count == claims->capacity) {
        int capacity = claims->capacity ? 2 * claims->capacity : 64;
        struct claim *rows = realloc(claims->rows, (size_t)capacity * sizeof *rows);
        if (!rows)
            return error_set(err, "out of memory: %d claims", capacity);
        claims->rows = rows;
        claims->capacity = capacity;
    }
    struct claim *added = claims->rows + claims->count++;
    *added = *row;
    snprintf(added->mesh, sizeof added->mesh, "%s", mesh);
    return 0;
}

void claims_release(struct claims *claims)
{
    free(claims->rows);
    *claims = (struct claims){0};
}

json_t *claims_to_json(const struct claims *claims)
{
    json_t *rows = json_array();
    for (int i = 0; rows && i < claims->count; i++) {
        const struct claim *row = claims->rows + i;
        json_t *json = json_pack("{s:s, s:s, s:s, s:s, s:f, s:f, s:b}", "name", row->name, "source",
                                 row->source, "claim", row->text, "mesh", row->mesh, "claimed",
                                 row->claimed, "measured", row->measured, "holds", row->holds);
        if (!json || json_array_append_new(rows, json)) {
            json_decref(rows);
            return NULL;
        }
    }
    return rows;
}

static int add_about(struct claims *claims, struct claim row, const char *mesh, struct error *err)
{
    row.holds = fabs(row.measured - row.claimed) <= 0.1 * row.claimed;
    return claims_add(claims, &row, mesh, err);
}

/* -- ratios --------------------------------------------------------------------------------- */

static int add_ratios(struct claims *claims, const char *name, const struct mesh *mesh,
                      struct error *err)
{
    struct topology topology;
    if (mesh_topology(mesh, &topology, err))
        return -1;
    double vertices = (double)(topology.vertex_count - topology.isolated.count);
    double edges = (double)topology.edge_count, faces = (double)topology.triangle_count;
    return add_about(claims,
                     (struct claim){.name = "faces-are-twice-vertices",
                                    .source = "000, 4.2, 4.4",
                                    .text = "F is about 2 V",
                                    .claimed = 2.0,
                                    .measured = faces / vertices},
                     name, err) ||
                   add_about(claims,
                             (struct claim){.name = "edges-are-three-times-vertices",
                                            .source = "000, 4.4",
                                            .text = "E is about 3 V",
                                            .claimed = 3.0,
                                            .measured = edges / vertices},
                             name, err) ||
                   add_about(claims,
                             (struct claim){.name = "valence-is-six",
                                            .source = "000, 002",
                                            .text = "a vertex has about 6 neighbours",
                                            .claimed = 6.0,
                                            .measured = 2.0 * edges / vertices},
                             name, err)
               ? -1
               : 0;
}

/* -- vertices processed --------------------------------------------------------------------- */

/* What one transformation of all positions processes, and the bytes of the tables. */
static int measure(const char *representation, const struct mesh *mesh, double *processed,
                   double *bytes, struct error *err)
{
    static const float identity[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    const struct representation *kind = representation_find(representation);
    void *self;
    *processed = *bytes = 0.0;
    if (!kind)
        return error_set(err, "there is no representation %s", representation);
    if (representation_new(kind, &self, mesh, err))
        return -1;
    *processed = (double)kind->transform(self, identity);
    *bytes = (double)kind->bytes(self);
    representation_delete(kind, self);
    return 0;
}

static int add_processed(struct claims *claims, const char *name, const struct mesh *mesh,
                         struct error *err)
{
    static const struct {
        const char *representation;
        struct claim row;
    } parts[] = {{"isolated-triangles",
                  {.name = "isolated-triangles-process-six-times",
                   .source = "000, 002",
                   .text = "isolated triangles: a vertex about 6 times",
                   .claimed = 6.0}},
                 {"triangle-strips",
                  {.name = "strips-process-twice",
                   .source = "000, 002, 4.3",
                   .text = "strips: a vertex close to 2 times",
                   .claimed = 2.0}},
                 {"indexed-mesh",
                  {.name = "indexed-mesh-processes-once",
                   .source = "000, 002",
                   .text = "indexed mesh: a vertex once",
                   .claimed = 1.0}}};
    double vertices = (double)mesh->vertex_count;
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        double processed, bytes;
        if (measure(parts[i].representation, mesh, &processed, &bytes, err))
            return -1;
        struct claim row = parts[i].row;
        row.measured = processed / vertices;
        if (add_about(claims, row, name, err))
            return -1;
    }
    return 0;
}

static int add_memory(struct claims *claims, const char *name, const struct mesh *mesh,
                      struct error *err)
{
    double processed, indexed, strips;
    if (measure("indexed-mesh", mesh, &processed, &indexed, err) ||
        measure("triangle-strips", mesh, &processed, &strips, err))
        return -1;
    return add_about(claims,
                     (struct claim){.name = "indexed-takes-three-halves-of-strips",
                                    .source = "000, 4.3",
                                    .text = "indexed mesh to strips: 3/2 of the bytes",
                                    .claimed = 1.5,
                                    .measured = indexed / strips},
                     name, err);
}

/* -- search in an indexed mesh -------------------------------------------------------------- */

/* An indexed mesh that counts the triangles that are looked at. Not for several threads. */
static int64_t triangles_read;

static void counting_face_vertices(const void *self, int32_t first, int32_t count, int32_t *corners)
{
    triangles_read += count;
    representation_find("indexed-mesh")->face_vertices(self, first, count, corners);
}

/* Pairs of vertices at random, which are hardly ever adjacent. */
static int add_search(struct claims *claims, const char *name, const struct mesh *mesh,
                      struct error *err)
{
    enum { PAIRS = 200 };
    struct representation counting = *representation_find("indexed-mesh");
    counting.face_vertices = counting_face_vertices;
    struct random rng;
    random_init(&rng, 9);
    triangles_read = 0;
    int asked = 0;
    for (int i = 0; i < PAIRS; i++) {
        int32_t u = (int32_t)random_below(&rng, (uint64_t)mesh->vertex_count);
        int32_t v = (int32_t)random_below(&rng, (uint64_t)mesh->vertex_count);
        if (u == v)
            continue;
        (void)faces_search_edge(&counting, mesh, NULL, u, v);
        asked++;
    }
    return add_about(claims,
                     (struct claim){.name = "adjacency-in-an-indexed-mesh-is-a-search",
                                    .source = "000, 002",
                                    .text = "is (u, v) an edge, indexed: n_t accesses",
                                    .claimed = (double)mesh->triangle_count,
                                    .measured = (double)triangles_read / asked},
                     name, err);
}

int claims_about_mesh(struct claims *claims, const char *name, const struct mesh *mesh,
                      struct error *err)
{
    if (add_ratios(claims, name, mesh, err) || add_processed(claims, name, mesh, err) ||
        add_memory(claims, name, mesh, err) || add_search(claims, name, mesh, err))
        return -1;
    return 0;
}
