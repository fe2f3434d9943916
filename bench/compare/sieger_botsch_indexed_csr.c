/* The operations of the paper on an indexed mesh with rows; see sieger_botsch.h.
 *
 * Row v, entries starts[v] ... starts[v + 1] - 1, has the faces of vertex v in order and, beside
 * each, the corner after v in it. Inside a manifold these are all neighbours of v, each once. */
#include "bench/compare/sieger_botsch.h"

#include "reference/representation/sides.h"
#include "reference/representation/vector.h"

#include <stdlib.h>
#include <string.h>

struct held {
    struct mesh mesh;
    int32_t *starts;     /* vertex_count + 1 */
    int32_t *faces;      /* 3 a triangle */
    int32_t *neighbours; /* 3 a triangle */
    uint8_t *is_inside;  /* a vertex: has faces and is on no boundary edge */
    float *face_normals, *vertex_normals;
};

static void release(void *self)
{
    struct held *held = self;
    mesh_release(&held->mesh);
    free(held->starts);
    free(held->faces);
    free(held->neighbours);
    free(held->is_inside);
    free(held->face_normals);
    free(held->vertex_normals);
    *held = (struct held){0};
}

/* -- rows ----------------------------------------------------------------------------------- */

/* Neighbours come before and after a vertex equally often but on the boundary, where one comes only
 * after it and another only before: there the sums differ. */
static void mark_inside(struct held *held)
{
    for (int32_t v = 0; v < held->mesh.vertex_count; v++) {
        int64_t difference = 0;
        for (int32_t i = held->starts[v]; i < held->starts[v + 1]; i++) {
            const int32_t *c = held->mesh.triangles + 3 * (int64_t)held->faces[i];
            difference += held->neighbours[i];
            difference -= (int64_t)c[0] + c[1] + c[2] - v - held->neighbours[i];
        }
        held->is_inside[v] = held->starts[v] < held->starts[v + 1] && difference == 0;
    }
}

/* Counting sort of the corners by vertex. */
static void fill_rows(struct held *held)
{
    const struct mesh *mesh = &held->mesh;
    memset(held->starts, 0, ((size_t)mesh->vertex_count + 1) * sizeof *held->starts);
    for (int64_t c = 0; c < 3 * (int64_t)mesh->triangle_count; c++)
        held->starts[mesh->triangles[c]]++;
    int32_t sum = 0;
    for (int32_t v = 0; v <= mesh->vertex_count; v++) {
        sum += held->starts[v];
        held->starts[v] = sum;
    }
    for (int32_t c = 3 * mesh->triangle_count - 1; c >= 0; c--) {
        int32_t place = --held->starts[mesh->triangles[c]];
        held->faces[place] = c / 3;
        held->neighbours[place] = mesh->triangles[c % 3 == 2 ? c - 2 : c + 1];
    }
    mark_inside(held);
}

/* Takes the mesh over, whatever happens. */
static int make_rows(struct held *held, struct mesh *mesh, struct error *err)
{
    size_t vertices = (size_t)mesh->vertex_count, triangles = (size_t)mesh->triangle_count;
    *held = (struct held){.mesh = *mesh,
                          .starts = malloc((vertices + 1) * sizeof *held->starts),
                          .faces = malloc(3 * triangles * sizeof *held->faces + 1),
                          .neighbours = malloc(3 * triangles * sizeof *held->neighbours + 1),
                          .is_inside = malloc(vertices + 1),
                          .face_normals = calloc(3 * triangles + 1, sizeof(float)),
                          .vertex_normals = calloc(3 * vertices + 1, sizeof(float))};
    *mesh = (struct mesh){0};
    if (held->starts && held->faces && held->neighbours && held->is_inside && held->face_normals &&
        held->vertex_normals) {
        fill_rows(held);
        return 0;
    }
    release(held);
    error_set(err, "out of memory: rows of %zu vertices", vertices);
    return -1;
}

/* The rows need a manifold: asks the matching of sides. */
static int require_manifold(const struct mesh *mesh, struct error *err)
{
    struct polygons polygons = polygons_of_mesh(mesh);
    int32_t *twin = malloc(3 * (size_t)mesh->triangle_count * sizeof *twin + 1);
    int32_t *fan = malloc((size_t)mesh->vertex_count * sizeof *fan + 1);
    int result = -1;
    if (!twin || !fan)
        error_set(err, "out of memory: sides of %d triangles", mesh->triangle_count);
    else if (sides_match(&polygons, twin, err) == 0)
        result = sides_fans(&polygons, twin, fan, err);
    free(twin);
    free(fan);
    return result;
}

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    struct held *held = self;
    struct mesh copy;
    *held = (struct held){0};
    if (require_manifold(mesh, err) || mesh_copy(&copy, mesh, err))
        return -1;
    return make_rows(held, &copy, err);
}

/* -- sweeps --------------------------------------------------------------------------------- */

static int64_t circulate(const void *self)
{
    const struct held *held = self;
    int64_t sum = 0;
    for (int32_t v = 0; v < held->mesh.vertex_count; v++)
        for (int32_t i = held->starts[v]; i < held->starts[v + 1]; i++)
            sum += held->faces[i];
    for (int64_t c = 0; c < 3 * (int64_t)held->mesh.triangle_count; c++)
        sum -= held->mesh.triangles[c];
    return sum;
}

static void centre(void *self)
{
    const struct mesh *mesh = &((struct held *)self)->mesh;
    struct vector sum = {0.0, 0.0, 0.0};
    for (int32_t v = 0; v < mesh->vertex_count; v++)
        sum = vector_add(sum, vector_at(mesh->positions, v));
    struct vector mean = vector_scale(sum, 1.0 / (mesh->vertex_count ? mesh->vertex_count : 1));
    for (int32_t v = 0; v < mesh->vertex_count; v++)
        vector_put(mesh->positions, v, vector_subtract(vector_at(mesh->positions, v), mean));
}

static void normals(void *self)
{
    struct held *held = self;
    const struct mesh *mesh = &held->mesh;
    for (int32_t f = 0; f < mesh->triangle_count; f++) {
        const int32_t *c = mesh->triangles + 3 * (int64_t)f;
        vector_put(held->face_normals, f,
                   vector_unit(triangle_normal(mesh->positions, c[0], c[1], c[2])));
    }
    for (int32_t v = 0; v < mesh->vertex_count; v++) {
        struct vector sum = {0.0, 0.0, 0.0};
        for (int32_t i = held->starts[v]; i < held->starts[v + 1]; i++)
            sum = vector_add(sum, vector_at(held->face_normals, held->faces[i]));
        vector_put(held->vertex_normals, v, vector_unit(sum));
    }
}

/* Sum of the neighbours of a vertex inside. */
static struct vector sum_around(const struct held *held, int32_t vertex)
{
    struct vector sum = {0.0, 0.0, 0.0};
    for (int32_t i = held->starts[vertex]; i < held->starts[vertex + 1]; i++)
        sum = vector_add(sum, vector_at(held->mesh.positions, held->neighbours[i]));
    return sum;
}

static void smooth(void *self)
{
    struct held *held = self;
    for (int32_t v = 0; v < held->mesh.vertex_count; v++)
        if (held->is_inside[v]) {
            int32_t count = held->starts[v + 1] - held->starts[v];
            vector_put(held->mesh.positions, v, vector_scale(sum_around(held, v), 1.0 / count));
        }
}

/* -- new tables ----------------------------------------------------------------------------- */

/* The face that runs from u to v, or -1: searched in the row of u. */
static int32_t face_beside(const struct held *held, int32_t u, int32_t v)
{
    for (int32_t i = held->starts[u]; i < held->starts[u + 1]; i++)
        if (held->neighbours[i] == v)
            return held->faces[i];
    return -1;
}

static void relax_vertices(const struct held *held, float *moved)
{
    for (int32_t v = 0; v < held->mesh.vertex_count; v++) {
        struct vector here = vector_at(held->mesh.positions, v);
        if (held->is_inside[v]) {
            int32_t count = held->starts[v + 1] - held->starts[v];
            double weight = paper_sqrt3_weight(count);
            here = vector_add(vector_scale(here, 1.0 - weight),
                              vector_scale(sum_around(held, v), weight / count));
        }
        vector_put(moved, v, here);
    }
}

static void add_centroids(const struct mesh *mesh, float *centroids)
{
    for (int32_t f = 0; f < mesh->triangle_count; f++) {
        const int32_t *c = mesh->triangles + 3 * (int64_t)f;
        struct vector sum = vector_add(
            vector_add(vector_at(mesh->positions, c[0]), vector_at(mesh->positions, c[1])),
            vector_at(mesh->positions, c[2]));
        vector_put(centroids, f, vector_scale(sum, 1.0 / 3.0));
    }
}

/* Of each side u -> v, split and then flipped: the triangle of u and the two centroids; on the
 * boundary that of the side and its own centroid. */
static void connect_centroids(const struct held *held, int32_t *triangles)
{
    const struct mesh *mesh = &held->mesh;
    for (int32_t f = 0; f < mesh->triangle_count; f++)
        for (int i = 0; i < 3; i++, triangles += 3) {
            const int32_t *c = mesh->triangles + 3 * (int64_t)f;
            int32_t u = c[i], v = c[(i + 1) % 3], across = face_beside(held, v, u);
            triangles[0] = u;
            triangles[1] = across < 0 ? v : mesh->vertex_count + across;
            triangles[2] = mesh->vertex_count + f;
        }
}

/* The structure of another mesh, which is taken over, in place of the present one. */
static int replace(struct held *held, struct mesh *mesh, struct error *err)
{
    struct held fresh;
    if (make_rows(&fresh, mesh, err))
        return -1;
    release(held);
    *held = fresh;
    return 0;
}

static int subdivide(void *self, struct error *err)
{
    struct held *held = self;
    const struct mesh *mesh = &held->mesh;
    struct mesh finer;
    if (mesh_init(&finer, (int64_t)mesh->vertex_count + mesh->triangle_count,
                  3 * (int64_t)mesh->triangle_count, err))
        return -1;
    relax_vertices(held, finer.positions);
    add_centroids(mesh, finer.positions + 3 * (int64_t)mesh->vertex_count);
    connect_centroids(held, finer.triangles);
    return replace(held, &finer, err);
}

/* Every face in three at the origin. */
static int split_faces(const struct mesh *mesh, struct mesh *split, struct error *err)
{
    if (mesh_init(split, (int64_t)mesh->vertex_count + mesh->triangle_count,
                  3 * (int64_t)mesh->triangle_count, err))
        return -1;
    if (mesh->vertex_count)
        memcpy(split->positions, mesh->positions,
               3 * (size_t)mesh->vertex_count * sizeof *split->positions);
    for (int64_t s = 0; s < 3 * (int64_t)mesh->triangle_count; s++) {
        int32_t *t = split->triangles + 3 * s;
        t[0] = mesh->triangles[s];
        t[1] = mesh->triangles[s % 3 == 2 ? s - 2 : s + 1];
        t[2] = mesh->vertex_count + (int32_t)(s / 3);
    }
    return 0;
}

/* Names every new vertex, those from vertex_count on, by the first corner of its face, and drops
 * the triangles that become degenerate. */
static int collapse_new(const struct mesh *split, int32_t vertex_count, struct mesh *mesh,
                        struct error *err)
{
    if (mesh_init(mesh, vertex_count, split->triangle_count / 3, err))
        return -1;
    if (vertex_count)
        memcpy(mesh->positions, split->positions,
               3 * (size_t)vertex_count * sizeof *mesh->positions);
    int32_t *target = mesh->triangles;
    for (int32_t t = 0; t < split->triangle_count; t++) {
        const int32_t *c = split->triangles + 3 * (int64_t)t;
        int32_t onto = split->triangles[9 * (int64_t)(c[2] - vertex_count)];
        if (c[0] == onto || c[1] == onto)
            continue;
        *target++ = c[0];
        *target++ = c[1];
        *target++ = onto;
    }
    return 0;
}

static int collapse(void *self, struct error *err)
{
    struct held *held = self;
    struct mesh split, mesh;
    int32_t vertex_count = held->mesh.vertex_count;
    struct held between;
    if (split_faces(&held->mesh, &split, err) || make_rows(&between, &split, err))
        return -1;
    int result = collapse_new(&between.mesh, vertex_count, &mesh, err);
    release(&between);
    return result ? -1 : replace(held, &mesh, err);
}

/* -- results -------------------------------------------------------------------------------- */

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    return mesh_copy(mesh, &((const struct held *)self)->mesh, err);
}

static const float *vertex_normals(const void *self)
{
    return ((const struct held *)self)->vertex_normals;
}

extern const struct paper_structure paper_indexed_csr;
const struct paper_structure paper_indexed_csr = {.name = "indexed-csr",
                                                  .title = "Indexed mesh + CSR",
                                                  .struct_bytes = sizeof(struct held),
                                                  .build = build,
                                                  .release = release,
                                                  .circulate = circulate,
                                                  .centre = centre,
                                                  .normals = normals,
                                                  .smooth = smooth,
                                                  .subdivide = subdivide,
                                                  .collapse = collapse,
                                                  .to_mesh = to_mesh,
                                                  .vertex_normals = vertex_normals};
