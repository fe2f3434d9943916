/* The operations of the paper on winged edges; see sieger_botsch.h. */
#include "bench/compare/sieger_botsch.h"

#include "reference/representation/vector.h"
#include "reference/representation/winged_edge_edit.h"

#include <stdlib.h>

struct held {
    struct winged_edge_mesh we;
    float *face_normals, *vertex_normals;
};

static int build(void *self, const struct mesh *mesh, struct error *err)
{
    struct held *held = self;
    struct polygons polygons = polygons_of_mesh(mesh);
    *held = (struct held){0};
    if (winged_edge_build(&held->we, &polygons, mesh->positions, err))
        return -1;
    held->face_normals = calloc(3 * (size_t)mesh->triangle_count + 1, sizeof(float));
    held->vertex_normals = calloc(3 * (size_t)mesh->vertex_count + 1, sizeof(float));
    if (held->face_normals && held->vertex_normals)
        return 0;
    winged_edge_release(&held->we);
    free(held->face_normals);
    free(held->vertex_normals);
    return error_set(err, "out of memory: normals");
}

static void release(void *self)
{
    struct held *held = self;
    winged_edge_release(&held->we);
    free(held->face_normals);
    free(held->vertex_normals);
    *held = (struct held){0};
}

static int64_t circulate(const void *self)
{
    const struct winged_edge_mesh *we = &((const struct held *)self)->we;
    int64_t sum = 0;
    for (int32_t v = 0; v < we->vertex_count; v++) {
        if (we->vertex_edge[v] < 0)
            continue;
        struct winged_side first = winged_edge_of_vertex(we, v), side = first;
        do {
            int32_t face = winged_edge_face(we, side);
            sum += face >= 0 ? face : 0;
            side = winged_edge_turn_left(we, side);
        } while (side.edge != first.edge);
    }
    for (int32_t f = 0; f < we->face_count; f++) {
        struct winged_side first = winged_edge_of_face(we, f), side = first;
        do {
            sum -= winged_edge_start(we, side);
            side = winged_edge_next(we, side);
        } while (side.edge != first.edge);
    }
    return sum;
}

static void centre(void *self)
{
    const struct winged_edge_mesh *we = &((struct held *)self)->we;
    struct vector sum = {0.0, 0.0, 0.0};
    for (int32_t v = 0; v < we->vertex_count; v++)
        sum = vector_add(sum, vector_at(we->positions, v));
    struct vector mean = vector_scale(sum, 1.0 / (we->vertex_count ? we->vertex_count : 1));
    for (int32_t v = 0; v < we->vertex_count; v++)
        vector_put(we->positions, v, vector_subtract(vector_at(we->positions, v), mean));
}

static struct vector sum_of_normals(const struct held *held, int32_t vertex)
{
    const struct winged_edge_mesh *we = &held->we;
    struct vector sum = {0.0, 0.0, 0.0};
    if (we->vertex_edge[vertex] < 0)
        return sum;
    struct winged_side first = winged_edge_of_vertex(we, vertex), side = first;
    do {
        int32_t face = winged_edge_face(we, side);
        if (face >= 0)
            sum = vector_add(sum, vector_at(held->face_normals, face));
        side = winged_edge_turn_left(we, side);
    } while (side.edge != first.edge);
    return sum;
}

static void normals(void *self)
{
    struct held *held = self;
    const struct winged_edge_mesh *we = &held->we;
    for (int32_t f = 0; f < we->face_count; f++) {
        struct winged_side side = winged_edge_of_face(we, f);
        int32_t a = winged_edge_start(we, side), b = winged_edge_end(we, side);
        int32_t c = winged_edge_end(we, winged_edge_next(we, side));
        vector_put(held->face_normals, f, vector_unit(triangle_normal(we->positions, a, b, c)));
    }
    for (int32_t v = 0; v < we->vertex_count; v++)
        vector_put(held->vertex_normals, v, vector_unit(sum_of_normals(held, v)));
}

/* Sum of the vertices around one; returns how many. */
static int32_t sum_around(const struct winged_edge_mesh *we, int32_t vertex, struct vector *sum)
{
    struct winged_side first = winged_edge_of_vertex(we, vertex), side = first;
    int32_t count = 0;
    *sum = (struct vector){0.0, 0.0, 0.0};
    do {
        *sum = vector_add(*sum, vector_at(we->positions, winged_edge_end(we, side)));
        count++;
        side = winged_edge_turn_left(we, side);
    } while (side.edge != first.edge);
    return count;
}

static bool is_inside(const struct winged_edge_mesh *we, int32_t vertex)
{
    return we->vertex_edge[vertex] >= 0 && !winged_edge_on_boundary(we, vertex);
}

static void smooth(void *self)
{
    const struct winged_edge_mesh *we = &((struct held *)self)->we;
    for (int32_t v = 0; v < we->vertex_count; v++) {
        if (!is_inside(we, v))
            continue;
        struct vector sum;
        int32_t count = sum_around(we, v, &sum);
        vector_put(we->positions, v, vector_scale(sum, 1.0 / count));
    }
}

/* -- edits ---------------------------------------------------------------------------------- */

static int reserve(struct winged_edge_mesh *we, struct error *err)
{
    int64_t faces = we->face_count;
    return winged_edge_reserve(we, faces, 2 * faces, 3 * faces, err);
}

/* Where sqrt(3) subdivision puts the old vertices; the caller owns the table. */
static float *relaxed_positions(const struct winged_edge_mesh *we)
{
    float *moved = malloc(3 * (size_t)we->vertex_count * sizeof *moved + 1);
    for (int32_t v = 0; moved && v < we->vertex_count; v++) {
        struct vector here = vector_at(we->positions, v), sum;
        if (is_inside(we, v)) {
            int32_t count = sum_around(we, v, &sum);
            double weight = paper_sqrt3_weight(count);
            here = vector_add(vector_scale(here, 1.0 - weight), vector_scale(sum, weight / count));
        }
        vector_put(moved, v, here);
    }
    return moved;
}

static int split_at_centroids(struct winged_edge_mesh *we, int32_t face_count, struct error *err)
{
    for (int32_t f = 0; f < face_count; f++) {
        struct winged_side side = winged_edge_of_face(we, f);
        int32_t c = winged_edge_end(we, winged_edge_next(we, side));
        struct vector sum =
            vector_add(vector_add(vector_at(we->positions, winged_edge_start(we, side)),
                                  vector_at(we->positions, winged_edge_end(we, side))),
                       vector_at(we->positions, c));
        float centroid[3];
        vector_put(centroid, 0, vector_scale(sum, 1.0 / 3.0));
        if (winged_edge_split_face(we, f, centroid, err) < 0)
            return -1;
    }
    return 0;
}

static int subdivide(void *self, struct error *err)
{
    struct winged_edge_mesh *we = &((struct held *)self)->we;
    int32_t vertex_count = we->vertex_count, edge_count = we->edge_count;
    if (reserve(we, err))
        return -1;
    float *moved = relaxed_positions(we);
    if (!moved)
        return error_set(err, "out of memory: subdividing %d faces", we->face_count);
    int result = split_at_centroids(we, we->face_count, err);
    for (int32_t v = 0; v < vertex_count; v++)
        vector_put(we->positions, v, vector_at(moved, v));
    free(moved);
    for (int32_t e = 0; result == 0 && e < edge_count; e++) {
        struct winged_side side = {e, 0};
        if (winged_edge_can_flip(we, side))
            winged_edge_flip(we, side);
    }
    return result;
}

static int collapse(void *self, struct error *err)
{
    struct winged_edge_mesh *we = &((struct held *)self)->we;
    static const float origin[3] = {0.0F, 0.0F, 0.0F};
    int32_t vertex_count = we->vertex_count, face_count = we->face_count;
    if (reserve(we, err))
        return -1;
    for (int32_t f = 0; f < face_count; f++)
        if (winged_edge_split_face(we, f, origin, err) < 0)
            return -1;
    for (int32_t v = vertex_count; v < vertex_count + face_count; v++)
        winged_edge_collapse(we, winged_edge_of_vertex(we, v));
    return winged_edge_compact(we, err);
}

/* -- results -------------------------------------------------------------------------------- */

static int to_mesh(const void *self, struct mesh *mesh, struct error *err)
{
    return winged_edge_to_mesh(&((const struct held *)self)->we, mesh, err);
}

static const float *vertex_normals(const void *self)
{
    return ((const struct held *)self)->vertex_normals;
}

extern const struct paper_structure paper_winged_edge;
const struct paper_structure paper_winged_edge = {.name = "winged-edge",
                                                  .title = "Winged edge",
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
