/* The operations of the paper on half edges; see sieger_botsch.h. */
#include "bench/compare/sieger_botsch.h"

#include "reference/representation/half_edge_edit.h"
#include "reference/representation/vector.h"

#include <stdlib.h>

struct held {
    struct half_edge_mesh he;
    float *face_normals, *vertex_normals;
};

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    struct held *held = self;
    struct polygons polygons = polygons_of_mesh(mesh);
    *held = (struct held){0};
    if (half_edge_build(&held->he, &polygons, mesh->positions, err))
        return -1;
    held->face_normals = calloc(3 * (size_t)mesh->triangle_count + 1, sizeof(float));
    held->vertex_normals = calloc(3 * (size_t)mesh->vertex_count + 1, sizeof(float));
    if (held->face_normals && held->vertex_normals)
        return 0;
    half_edge_release(&held->he);
    free(held->face_normals);
    free(held->vertex_normals);
    return error_set(err, "out of memory: normals");
}

static void release(void *self)
{
    struct held *held = self;
    half_edge_release(&held->he);
    free(held->face_normals);
    free(held->vertex_normals);
    *held = (struct held){0};
}

static int64_t circulate(const void *self)
{
    const struct half_edge_mesh *he = &((const struct held *)self)->he;
    int64_t sum = 0;
    for (int32_t v = 0; v < he->vertex_count; v++) {
        int32_t first = he->vertex_half_edge[v], h = first;
        if (first < 0)
            continue;
        do {
            int32_t face = he->half_edges[h].face;
            sum += face >= 0 ? face : 0;
            h = half_edge_turn_right(he, h);
        } while (h != first);
    }
    for (int32_t f = 0; f < he->face_count; f++) {
        int32_t first = he->face_half_edge[f], h = first;
        do {
            sum -= he->half_edges[h].origin;
            h = he->half_edges[h].next;
        } while (h != first);
    }
    return sum;
}

static void centre(void *self)
{
    const struct half_edge_mesh *he = &((struct held *)self)->he;
    struct vector sum = {0.0, 0.0, 0.0};
    for (int32_t v = 0; v < he->vertex_count; v++)
        sum = vector_add(sum, vector_at(he->positions, v));
    struct vector mean = vector_scale(sum, 1.0 / (he->vertex_count ? he->vertex_count : 1));
    for (int32_t v = 0; v < he->vertex_count; v++)
        vector_put(he->positions, v, vector_subtract(vector_at(he->positions, v), mean));
}

static struct vector sum_of_normals(const struct held *held, int32_t vertex)
{
    const struct half_edge_mesh *he = &held->he;
    struct vector sum = {0.0, 0.0, 0.0};
    int32_t first = he->vertex_half_edge[vertex], h = first;
    if (first < 0)
        return sum;
    do {
        int32_t face = he->half_edges[h].face;
        if (face >= 0)
            sum = vector_add(sum, vector_at(held->face_normals, face));
        h = half_edge_turn_right(he, h);
    } while (h != first);
    return sum;
}

static void normals(void *self)
{
    struct held *held = self;
    const struct half_edge_mesh *he = &held->he;
    for (int32_t f = 0; f < he->face_count; f++) {
        struct half_edge a = he->half_edges[he->face_half_edge[f]], b = he->half_edges[a.next];
        int32_t c = he->half_edges[b.next].origin;
        vector_put(held->face_normals, f,
                   vector_unit(triangle_normal(he->positions, a.origin, b.origin, c)));
    }
    for (int32_t v = 0; v < he->vertex_count; v++)
        vector_put(held->vertex_normals, v, vector_unit(sum_of_normals(held, v)));
}

/* Sum of the vertices around one; returns how many. */
static int32_t sum_around(const struct half_edge_mesh *he, int32_t vertex, struct vector *sum)
{
    int32_t first = he->vertex_half_edge[vertex], h = first, count = 0;
    *sum = (struct vector){0.0, 0.0, 0.0};
    do {
        struct half_edge twin = he->half_edges[he->half_edges[h].twin];
        *sum = vector_add(*sum, vector_at(he->positions, twin.origin));
        count++;
        h = twin.next;
    } while (h != first);
    return count;
}

static bool is_inside(const struct half_edge_mesh *he, int32_t vertex)
{
    return he->vertex_half_edge[vertex] >= 0 && !half_edge_on_boundary(he, vertex);
}

static void smooth(void *self)
{
    const struct half_edge_mesh *he = &((struct held *)self)->he;
    for (int32_t v = 0; v < he->vertex_count; v++) {
        if (!is_inside(he, v))
            continue;
        struct vector sum;
        int32_t count = sum_around(he, v, &sum);
        vector_put(he->positions, v, vector_scale(sum, 1.0 / count));
    }
}

/* -- edits ---------------------------------------------------------------------------------- */

static int reserve(struct half_edge_mesh *he, struct error *err)
{
    int64_t faces = he->face_count;
    return half_edge_reserve(he, faces, 2 * faces, 6 * faces, err);
}

/* Where sqrt(3) subdivision puts the old vertices; the caller owns the table. */
static float *relaxed_positions(const struct half_edge_mesh *he)
{
    float *moved = malloc(3 * (size_t)he->vertex_count * sizeof *moved + 1);
    for (int32_t v = 0; moved && v < he->vertex_count; v++) {
        struct vector here = vector_at(he->positions, v), sum;
        if (is_inside(he, v)) {
            int32_t count = sum_around(he, v, &sum);
            double weight = paper_sqrt3_weight(count);
            here = vector_add(vector_scale(here, 1.0 - weight), vector_scale(sum, weight / count));
        }
        vector_put(moved, v, here);
    }
    return moved;
}

static int split_at_centroids(struct half_edge_mesh *he, int32_t face_count, struct error *err)
{
    for (int32_t f = 0; f < face_count; f++) {
        struct half_edge a = he->half_edges[he->face_half_edge[f]], b = he->half_edges[a.next];
        struct vector sum = vector_add(
            vector_add(vector_at(he->positions, a.origin), vector_at(he->positions, b.origin)),
            vector_at(he->positions, he->half_edges[b.next].origin));
        float centroid[3];
        vector_put(centroid, 0, vector_scale(sum, 1.0 / 3.0));
        if (half_edge_split_face(he, f, centroid, err) < 0)
            return -1;
    }
    return 0;
}

static int subdivide(void *self, struct error *err)
{
    struct half_edge_mesh *he = &((struct held *)self)->he;
    int32_t vertex_count = he->vertex_count, half_edge_count = he->half_edge_count;
    if (reserve(he, err))
        return -1;
    float *moved = relaxed_positions(he);
    if (!moved)
        return error_set(err, "out of memory: subdividing %d faces", he->face_count);
    int result = split_at_centroids(he, he->face_count, err);
    for (int32_t v = 0; v < vertex_count; v++)
        vector_put(he->positions, v, vector_at(moved, v));
    free(moved);
    for (int32_t h = 0; result == 0 && h < half_edge_count; h++)
        if (he->half_edges[h].twin > h && half_edge_can_flip(he, h))
            half_edge_flip(he, h);
    return result;
}

static int collapse(void *self, struct error *err)
{
    struct half_edge_mesh *he = &((struct held *)self)->he;
    static const float origin[3] = {0.0F, 0.0F, 0.0F};
    int32_t vertex_count = he->vertex_count, face_count = he->face_count;
    if (reserve(he, err))
        return -1;
    for (int32_t f = 0; f < face_count; f++)
        if (half_edge_split_face(he, f, origin, err) < 0)
            return -1;
    for (int32_t v = vertex_count; v < vertex_count + face_count; v++)
        half_edge_collapse(he, he->vertex_half_edge[v]);
    return half_edge_compact(he, err);
}

/* -- results -------------------------------------------------------------------------------- */

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    return half_edge_to_mesh(&((const struct held *)self)->he, mesh, err);
}

static const float *vertex_normals(const void *self)
{
    return ((const struct held *)self)->vertex_normals;
}

extern const struct paper_structure paper_half_edge;
const struct paper_structure paper_half_edge = {.name = "half-edge",
                                                .title = "Half edge",
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
