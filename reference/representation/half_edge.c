/* Half edges: building, checking, and back; see half_edge.h. */
#include "reference/representation/half_edge.h"

#include <stdlib.h>
#include <string.h>

/* -- storage -------------------------------------------------------------------------------- */

void half_edge_release(struct half_edge_mesh *he)
{
    free(he->positions);
    free(he->vertex_half_edge);
    free(he->face_half_edge);
    free(he->half_edges);
    *he = (struct half_edge_mesh){0};
}

static int allocate(struct half_edge_mesh *he, int64_t vertex_count, int64_t face_count,
                    int64_t half_edge_count, struct error *err)
{
    *he = (struct half_edge_mesh){0};
    if (half_edge_count > INT32_MAX)
        return error_set(err, "%lld half edges are more than an int32 can number",
                         (long long)half_edge_count);
    he->positions = malloc(3 * (size_t)vertex_count * sizeof *he->positions + 1);
    he->vertex_half_edge = malloc((size_t)vertex_count * sizeof *he->vertex_half_edge + 1);
    he->face_half_edge = malloc((size_t)face_count * sizeof *he->face_half_edge + 1);
    he->half_edges = calloc((size_t)half_edge_count + 1, sizeof *he->half_edges);
    if (!he->positions || !he->vertex_half_edge || !he->face_half_edge || !he->half_edges) {
        half_edge_release(he);
        error_set(err, "out of memory: %lld half edges", (long long)half_edge_count);
        return -1;
    }
    he->vertex_count = he->vertex_capacity = (int32_t)vertex_count;
    he->face_count = he->face_capacity = (int32_t)face_count;
    he->half_edge_count = he->half_edge_capacity = (int32_t)half_edge_count;
    return 0;
}

/* -- building ------------------------------------------------------------------------------- */

/* The half edges of faces, numbered like the sides; twins as matched, -1 on the boundary. */
static void fill_inner(struct half_edge_mesh *he, const struct polygons *polygons,
                       const int32_t *twin)
{
    for (int32_t f = 0; f < polygons->face_count; f++) {
        int32_t first = polygons_start(polygons, f), stop = polygons_start(polygons, f + 1);
        he->face_half_edge[f] = first;
        for (int32_t s = first; s < stop; s++)
            he->half_edges[s] = (struct half_edge){.origin = polygons->corners[s],
                                                   .twin = twin[s],
                                                   .next = s + 1 < stop ? s + 1 : first,
                                                   .face = f};
    }
}

/* A twin without a face for each inner half edge that has none, and the loops that these make. At a
 * vertex of one fan only one of them starts; vertex_half_edge remembers it meanwhile. */
static void fill_outer(struct half_edge_mesh *he, int32_t inner_count)
{
    int32_t outer = inner_count;
    for (int32_t h = 0; h < inner_count; h++) {
        struct half_edge *inner = he->half_edges + h;
        if (inner->twin >= 0)
            continue;
        int32_t end = he->half_edges[inner->next].origin;
        he->half_edges[outer] =
            (struct half_edge){.origin = end, .twin = h, .next = -1, .face = -1};
        he->vertex_half_edge[end] = outer;
        inner->twin = outer++;
    }
    for (int32_t h = inner_count; h < outer; h++)
        he->half_edges[h].next = he->vertex_half_edge[half_edge_end(he, h)];
}

static int build(struct half_edge_mesh *he, const struct polygons *polygons, const float *positions,
                 int32_t *twin, int32_t *fan, struct error *err)
{
    if (sides_match(polygons, twin, err) || sides_fans(polygons, twin, fan, err))
        return -1;
    int32_t inner_count = polygons_side_count(polygons);
    int64_t half_edge_count = inner_count;
    for (int32_t s = 0; s < inner_count; s++)
        half_edge_count += twin[s] < 0;
    if (allocate(he, polygons->vertex_count, polygons->face_count, half_edge_count, err))
        return -1;
    fill_inner(he, polygons, twin);
    fill_outer(he, inner_count);
    size_t vertex_count = (size_t)polygons->vertex_count;
    if (vertex_count) {
        memcpy(he->positions, positions, 3 * vertex_count * sizeof *positions);
        memcpy(he->vertex_half_edge, fan, vertex_count * sizeof *fan);
    }
    return 0;
}

int half_edge_build(struct half_edge_mesh *he, const struct polygons *polygons,
                    const float *positions, struct error *err)
{
    *he = (struct half_edge_mesh){0};
    int32_t *twin = malloc((size_t)polygons_side_count(polygons) * sizeof *twin + 1);
    int32_t *fan = malloc((size_t)polygons->vertex_count * sizeof *fan + 1);
    int result =
        twin && fan ? build(he, polygons, positions, twin, fan, err)
                    : error_set(err, "out of memory: half edges of %d faces", polygons->face_count);
    free(twin);
    free(fan);
    return result;
}

/* -- checking ------------------------------------------------------------------------------- */

static bool is_half_edge(const struct half_edge_mesh *he, int32_t h)
{
    return h >= 0 && h < he->half_edge_count && he->half_edges[h].origin >= 0;
}

static int check_half_edge(const struct half_edge_mesh *he, int32_t h, struct error *err)
{
    struct half_edge half = he->half_edges[h];
    if (half.origin >= he->vertex_count || he->vertex_half_edge[half.origin] < 0)
        return error_set(err, "half edge %d starts at %d, which is no vertex in use", h,
                         half.origin);
    if (half.face < -1 || half.face >= he->face_count ||
        (half.face >= 0 && he->face_half_edge[half.face] < 0))
        return error_set(err, "half edge %d has face %d, which is none", h, half.face);
    if (!is_half_edge(he, half.twin) || half.twin == h || he->half_edges[half.twin].twin != h)
        return error_set(err, "half edge %d is not the twin of its twin %d", h, half.twin);
    if (!is_half_edge(he, half.next))
        return error_set(err, "half edge %d has next %d, which is none", h, half.next);
    if (he->half_edges[half.next].origin != he->half_edges[half.twin].origin)
        return error_set(err, "half edge %d ends at %d, its next %d starts at %d", h,
                         he->half_edges[half.twin].origin, half.next,
                         he->half_edges[half.next].origin);
    if (he->half_edges[half.next].face != half.face)
        return error_set(err, "half edge %d has face %d, its next %d has face %d", h, half.face,
                         half.next, he->half_edges[half.next].face);
    if (half.face < 0 && he->half_edges[half.twin].face < 0)
        return error_set(err, "half edge %d and its twin %d have no face", h, half.twin);
    return 0;
}

/* Follows a cycle of `step` from `first`, marks what it meets, and returns its length; -1 when it
 * runs into a half edge marked before. */
static int32_t mark_cycle(const struct half_edge_mesh *he, int32_t first, bool around_vertex,
                          uint8_t *marked)
{
    int32_t length = 0, h = first;
    do {
        if (marked[h])
            return -1;
        marked[h] = 1;
        length++;
        h = around_vertex ? half_edge_turn_right(he, h) : he->half_edges[h].next;
    } while (h != first);
    return length;
}

static int check_faces(const struct half_edge_mesh *he, uint8_t *marked, struct error *err)
{
    for (int32_t f = 0; f < he->face_count; f++) {
        int32_t h = he->face_half_edge[f];
        if (h == HALF_EDGE_REMOVED)
            continue;
        if (!is_half_edge(he, h) || he->half_edges[h].face != f)
            return error_set(err, "face %d has half edge %d, which is not its own", f, h);
        if (mark_cycle(he, h, false, marked) < 3)
            return error_set(err, "face %d has half edges that are no cycle of 3 or more", f);
    }
    for (int32_t h = 0; h < he->half_edge_count; h++)
        if (he->half_edges[h].origin >= 0 && !marked[h]) {
            if (he->half_edges[h].face >= 0)
                return error_set(err, "half edge %d is not in the cycle of its face %d", h,
                                 he->half_edges[h].face);
            if (mark_cycle(he, h, false, marked) < 0)
                return error_set(err, "half edge %d is not in a boundary loop", h);
        }
    return 0;
}

static int check_vertices(const struct half_edge_mesh *he, uint8_t *marked, struct error *err)
{
    for (int32_t v = 0; v < he->vertex_count; v++) {
        int32_t h = he->vertex_half_edge[v];
        if (h == HALF_EDGE_REMOVED || h == -1)
            continue;
        if (!is_half_edge(he, h) || he->half_edges[h].origin != v)
            return error_set(err, "vertex %d has half edge %d, which does not leave it", v, h);
        if (mark_cycle(he, h, true, marked) < 0)
            return error_set(err, "vertex %d: the half edges around it are no cycle", v);
    }
    for (int32_t h = 0; h < he->half_edge_count; h++) {
        struct half_edge half = he->half_edges[h];
        if (half.origin < 0)
            continue;
        if (!marked[h])
            return error_set(err, "vertex %d is non-manifold: half edge %d is in another fan",
                             half.origin, h);
        if (he->half_edges[half.twin].face < 0 && he->vertex_half_edge[half.origin] != h)
            return error_set(err, "vertex %d is on the boundary: it should have half edge %d",
                             half.origin, h);
    }
    return 0;
}

int half_edge_check(const struct half_edge_mesh *he, struct error *err)
{
    for (int32_t h = 0; h < he->half_edge_count; h++)
        if (he->half_edges[h].origin != HALF_EDGE_REMOVED &&
            (he->half_edges[h].origin < 0
                 ? error_set(err, "half edge %d starts at %d, which is no vertex", h,
                             he->half_edges[h].origin)
                 : check_half_edge(he, h, err)))
            return -1;
    uint8_t *marked = calloc(2 * (size_t)he->half_edge_count + 1, 1);
    if (!marked)
        return error_set(err, "out of memory: checking %d half edges", he->half_edge_count);
    int result = check_faces(he, marked, err);
    if (!result)
        result = check_vertices(he, marked + he->half_edge_count, err);
    free(marked);
    return result;
}

/* -- back to an indexed mesh ---------------------------------------------------------------- */

int half_edge_to_mesh(const struct half_edge_mesh *he, struct mesh *mesh, struct error *err)
{
    if (mesh_init(mesh, he->vertex_count, he->face_count, err))
        return -1;
    if (he->vertex_count)
        memcpy(mesh->positions, he->positions,
               3 * (size_t)he->vertex_count * sizeof *mesh->positions);
    for (int32_t f = 0; f < he->face_count; f++) {
        int32_t h = he->face_half_edge[f];
        for (int corner = 0; h >= 0 && corner < 3; corner++, h = he->half_edges[h].next)
            mesh->triangles[3 * (int64_t)f + corner] = he->half_edges[h].origin;
        if (h != he->face_half_edge[f] || h < 0) {
            mesh_release(mesh);
            return error_set(err, "face %d is no triangle", f);
        }
    }
    return 0;
}

/* -- steps and walks ------------------------------------------------------------------------ */

int32_t half_edge_previous(const struct half_edge_mesh *he, int32_t h)
{
    if (he->half_edges[h].face >= 0)
        return he->half_edges[half_edge_turn_left(he, h)].twin;
    int32_t before = h;
    while (half_edge_turn_right(he, before) != h)
        before = half_edge_turn_right(he, before);
    return he->half_edges[before].twin;
}

int32_t half_edge_find(const struct half_edge_mesh *he, int32_t u, int32_t v)
{
    int32_t first = he->vertex_half_edge[u], h = first;
    if (first < 0)
        return -1;
    do {
        if (half_edge_end(he, h) == v)
            return h;
        h = half_edge_turn_right(he, h);
    } while (h != first);
    return -1;
}

int32_t half_edge_outgoing(const struct half_edge_mesh *he, int32_t vertex, int32_t *half_edges,
                           int32_t capacity)
{
    int32_t first = he->vertex_half_edge[vertex], h = first, count = 0;
    if (first < 0)
        return 0;
    for (;;) {
        if (count < capacity)
            half_edges[count] = h;
        count++;
        if (he->half_edges[h].face < 0)
            return count;
        h = half_edge_turn_left(he, h);
        if (h == first)
            return count;
    }
}
