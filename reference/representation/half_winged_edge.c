/* Half-winged edges: building, checking, and back; see half_winged_edge.h. */
#include "reference/representation/half_winged_edge.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* -- storage -------------------------------------------------------------------------------- */

void half_winged_edge_release(struct half_winged_edge_mesh *hw)
{
    free(hw->positions);
    free(hw->vertex_half_edge);
    free(hw->face_half_edge);
    free(hw->half_edges);
    *hw = (struct half_winged_edge_mesh){0};
}

static int allocate(struct half_winged_edge_mesh *hw, int64_t vertex_count, int64_t face_count,
                    int64_t half_edge_count, struct error *err)
{
    *hw = (struct half_winged_edge_mesh){0};
    if (half_edge_count > INT32_MAX)
        return error_set(err, "%lld half edges are more than an int32 can number",
                         (long long)half_edge_count);
    hw->positions = malloc(3 * (size_t)vertex_count * sizeof *hw->positions + 1);
    hw->vertex_half_edge = calloc((size_t)vertex_count + 1, sizeof *hw->vertex_half_edge);
    hw->face_half_edge = malloc((size_t)face_count * sizeof *hw->face_half_edge + 1);
    hw->half_edges = calloc((size_t)half_edge_count + 1, sizeof *hw->half_edges);
    if (!hw->positions || !hw->vertex_half_edge || !hw->face_half_edge || !hw->half_edges) {
        half_winged_edge_release(hw);
        error_set(err, "out of memory: %lld half edges", (long long)half_edge_count);
        return -1;
    }
    hw->vertex_count = (int32_t)vertex_count;
    hw->face_count = (int32_t)face_count;
    hw->half_edge_count = (int32_t)half_edge_count;
    return 0;
}

/* -- building ------------------------------------------------------------------------------- */

/* What the steps of the build share; number_of_side is the half edge of each side. */
struct plan {
    const struct polygons *polygons;
    int32_t *twin, *fan, *number_of_side;
    int32_t edge_count;
};

/* Edges are numbered as reading the sides in order meets them; the second half comes later by the
 * number of edges, which is known only at the end. */
static void number_half_edges(struct plan *plan)
{
    int32_t side_count = polygons_side_count(plan->polygons);
    plan->edge_count = 0;
    for (int32_t s = 0; s < side_count; s++)
        if (plan->twin[s] < 0 || plan->twin[s] > s)
            plan->number_of_side[s] = plan->edge_count++;
    for (int32_t s = 0; s < side_count; s++)
        if (plan->twin[s] >= 0 && plan->twin[s] < s)
            plan->number_of_side[s] = plan->number_of_side[plan->twin[s]] + plan->edge_count;
}

static void fill_inner(struct half_winged_edge_mesh *hw, const struct plan *plan)
{
    const struct polygons *polygons = plan->polygons;
    for (int32_t f = 0; f < polygons->face_count; f++) {
        int32_t first = polygons_start(polygons, f), last = polygons_start(polygons, f + 1) - 1;
        hw->face_half_edge[f] = plan->number_of_side[first];
        for (int32_t s = first; s <= last; s++) {
            int32_t h = plan->number_of_side[s];
            hw->half_edges[h] = (struct half_winged_edge){
                .start = polygons->corners[s],
                .end = polygons->corners[s == last ? first : s + 1],
                .twin = h < plan->edge_count ? h + plan->edge_count : h - plan->edge_count,
                .face = f,
                .previous = plan->number_of_side[s == first ? last : s - 1],
                .next = plan->number_of_side[s == last ? first : s + 1]};
        }
    }
}

/* The second halves of boundary edges. At a vertex of one fan only one of them starts;
 * vertex_half_edge remembers it meanwhile. */
static void fill_outer(struct half_winged_edge_mesh *hw, const struct plan *plan)
{
    for (int32_t s = 0; s < polygons_side_count(plan->polygons); s++) {
        if (plan->twin[s] >= 0)
            continue;
        const struct half_winged_edge *inner = hw->half_edges + plan->number_of_side[s];
        hw->half_edges[inner->twin] = (struct half_winged_edge){
            .start = inner->end, .end = inner->start, .twin = plan->number_of_side[s], .face = -1};
        hw->vertex_half_edge[inner->end] = inner->twin;
    }
    for (int32_t s = 0; s < polygons_side_count(plan->polygons); s++) {
        if (plan->twin[s] >= 0)
            continue;
        int32_t h = hw->half_edges[plan->number_of_side[s]].twin;
        hw->half_edges[h].next = hw->vertex_half_edge[hw->half_edges[h].end];
        hw->half_edges[hw->half_edges[h].next].previous = h;
    }
}

/* What the faces have at their corners. */
static void fill_attributes(struct half_winged_edge_mesh *hw, const struct plan *plan,
                            const float *normals, const float *textures)
{
    for (int64_t s = 0; s < polygons_side_count(plan->polygons); s++) {
        struct half_winged_edge *half = hw->half_edges + plan->number_of_side[s];
        if (normals)
            memcpy(half->normal, normals + 3 * s, sizeof half->normal);
        if (textures)
            memcpy(half->texture, textures + 2 * s, sizeof half->texture);
    }
}

static int build(struct half_winged_edge_mesh *hw, struct plan *plan, const float *positions,
                 struct error *err)
{
    const struct polygons *polygons = plan->polygons;
    if (sides_match(polygons, plan->twin, err) || sides_fans(polygons, plan->twin, plan->fan, err))
        return -1;
    number_half_edges(plan);
    if (allocate(hw, polygons->vertex_count, polygons->face_count, 2 * (int64_t)plan->edge_count,
                 err))
        return -1;
    fill_inner(hw, plan);
    fill_outer(hw, plan);
    for (int32_t v = 0; v < hw->vertex_count; v++)
        hw->vertex_half_edge[v] = plan->fan[v] < 0 ? -1 : plan->number_of_side[plan->fan[v]];
    if (hw->vertex_count)
        memcpy(hw->positions, positions, 3 * (size_t)hw->vertex_count * sizeof *positions);
    return 0;
}

int half_winged_edge_build(struct half_winged_edge_mesh *hw, const struct polygons *polygons,
                           const float *positions, const float *normals, const float *textures,
                           struct error *err)
{
    *hw = (struct half_winged_edge_mesh){0};
    size_t side_count = (size_t)polygons_side_count(polygons);
    struct plan plan = {.polygons = polygons,
                        .twin = malloc(side_count * sizeof *plan.twin + 1),
                        .number_of_side = calloc(side_count + 1, sizeof *plan.number_of_side),
                        .fan = malloc((size_t)polygons->vertex_count * sizeof *plan.fan + 1)};
    int result = -1;
    if (plan.twin && plan.number_of_side && plan.fan)
        result = build(hw, &plan, positions, err);
    else
        error_set(err, "out of memory: half edges of %d faces", polygons->face_count);
    if (result == 0) {
        fill_attributes(hw, &plan, normals, textures);
        if (!normals)
            result = half_winged_edge_shade(hw, 180.0, err);
        if (result)
            half_winged_edge_release(hw);
    }
    free(plan.twin);
    free(plan.number_of_side);
    free(plan.fan);
    return result;
}

/* -- checking ------------------------------------------------------------------------------- */

static bool is_half_edge(const struct half_winged_edge_mesh *hw, int32_t h)
{
    return h >= 0 && h < hw->half_edge_count;
}

static int check_numbers(const struct half_winged_edge_mesh *hw, int32_t h, struct error *err)
{
    const struct half_winged_edge *half = hw->half_edges + h;
    if (half->start < 0 || half->start >= hw->vertex_count || hw->vertex_half_edge[half->start] < 0)
        return error_set(err, "half edge %d starts at %d, which is no vertex in use", h,
                         half->start);
    if (half->face < -1 || half->face >= hw->face_count)
        return error_set(err, "half edge %d has face %d, which is none", h, half->face);
    if (!is_half_edge(hw, half->twin) || half->twin == h || hw->half_edges[half->twin].twin != h)
        return error_set(err, "half edge %d is not the twin of its twin %d", h, half->twin);
    if (!is_half_edge(hw, half->next) || hw->half_edges[half->next].previous != h)
        return error_set(err, "half edge %d is not the one before its next %d", h, half->next);
    if (!is_half_edge(hw, half->previous) || hw->half_edges[half->previous].next != h)
        return error_set(err, "half edge %d is not the one after its previous %d", h,
                         half->previous);
    return 0;
}

static int check_neighbours(const struct half_winged_edge_mesh *hw, int32_t h, struct error *err)
{
    const struct half_winged_edge *half = hw->half_edges + h;
    const struct half_winged_edge *next = hw->half_edges + half->next;
    if (half->end != hw->half_edges[half->twin].start)
        return error_set(err, "half edge %d ends at %d, its twin %d starts at %d", h, half->end,
                         half->twin, hw->half_edges[half->twin].start);
    if (half->end != next->start)
        return error_set(err, "half edge %d ends at %d, its next %d starts at %d", h, half->end,
                         half->next, next->start);
    if (half->face != next->face)
        return error_set(err, "half edge %d has face %d, its next %d has face %d", h, half->face,
                         half->next, next->face);
    if (half->face < 0 && hw->half_edges[half->twin].face < 0)
        return error_set(err, "half edge %d and its twin %d have no face", h, half->twin);
    return 0;
}

static int check_attributes(const struct half_winged_edge_mesh *hw, int32_t h, struct error *err)
{
    const struct half_winged_edge *half = hw->half_edges + h;
    double square = 0.0;
    for (int axis = 0; axis < 3; axis++)
        square += (double)half->normal[axis] * (double)half->normal[axis];
    bool is_zero = square == 0.0, is_unit = fabs(square - 1.0) < 1e-4;
    if (!(is_zero || (is_unit && half->face >= 0)))
        return error_set(err, "half edge %d has a normal of length %g", h, sqrt(square));
    if (!isfinite(half->texture[0]) || !isfinite(half->texture[1]))
        return error_set(err, "half edge %d has no finite texture coordinates", h);
    return 0;
}

/* Follows a cycle of `step` from `first`, marks what it meets, and returns its length; -1 when it
 * runs into a half edge marked before. */
static int32_t mark_cycle(const struct half_winged_edge_mesh *hw, int32_t first, bool around_vertex,
                          uint8_t *marked)
{
    int32_t length = 0, h = first;
    do {
        if (marked[h])
            return -1;
        marked[h] = 1;
        length++;
        h = around_vertex ? half_winged_edge_turn_right(hw, h) : hw->half_edges[h].next;
    } while (h != first);
    return length;
}

static int check_faces(const struct half_winged_edge_mesh *hw, uint8_t *marked, struct error *err)
{
    for (int32_t f = 0; f < hw->face_count; f++) {
        int32_t h = hw->face_half_edge[f];
        if (!is_half_edge(hw, h) || hw->half_edges[h].face != f)
            return error_set(err, "face %d has half edge %d, which is not its own", f, h);
        if (mark_cycle(hw, h, false, marked) < 3)
            return error_set(err, "face %d has half edges that are no cycle of 3 or more", f);
    }
    for (int32_t h = 0; h < hw->half_edge_count; h++)
        if (!marked[h]) {
            if (hw->half_edges[h].face >= 0)
                return error_set(err, "half edge %d is not in the cycle of its face %d", h,
                                 hw->half_edges[h].face);
            if (mark_cycle(hw, h, false, marked) < 0)
                return error_set(err, "half edge %d is not in a boundary loop", h);
        }
    return 0;
}

static int check_vertices(const struct half_winged_edge_mesh *hw, uint8_t *marked,
                          struct error *err)
{
    for (int32_t v = 0; v < hw->vertex_count; v++) {
        int32_t h = hw->vertex_half_edge[v];
        if (h == -1)
            continue;
        if (!is_half_edge(hw, h) || hw->half_edges[h].start != v)
            return error_set(err, "vertex %d has half edge %d, which does not leave it", v, h);
        if (mark_cycle(hw, h, true, marked) < 0)
            return error_set(err, "vertex %d: the half edges around it are no cycle", v);
    }
    for (int32_t h = 0; h < hw->half_edge_count; h++) {
        struct half_winged_edge half = hw->half_edges[h];
        if (!marked[h])
            return error_set(err, "vertex %d is non-manifold: half edge %d is in another fan",
                             half.start, h);
        if (hw->half_edges[half.twin].face < 0 && hw->vertex_half_edge[half.start] != h)
            return error_set(err, "vertex %d is on the boundary: it should have half edge %d",
                             half.start, h);
    }
    return 0;
}

int half_winged_edge_check(const struct half_winged_edge_mesh *hw, struct error *err)
{
    for (int32_t h = 0; h < hw->half_edge_count; h++)
        if (check_numbers(hw, h, err) || check_attributes(hw, h, err))
            return -1;
    for (int32_t h = 0; h < hw->half_edge_count; h++)
        if (check_neighbours(hw, h, err))
            return -1;
    uint8_t *marked = calloc(2 * (size_t)hw->half_edge_count + 1, 1);
    if (!marked)
        return error_set(err, "out of memory: checking %d half edges", hw->half_edge_count);
    int result = check_faces(hw, marked, err);
    if (!result)
        result = check_vertices(hw, marked + hw->half_edge_count, err);
    free(marked);
    return result;
}

/* -- back to an indexed mesh ---------------------------------------------------------------- */

int half_winged_edge_to_mesh(const struct half_winged_edge_mesh *hw, struct mesh *mesh,
                             struct error *err)
{
    if (mesh_init(mesh, hw->vertex_count, hw->face_count, err))
        return -1;
    if (hw->vertex_count)
        memcpy(mesh->positions, hw->positions,
               3 * (size_t)hw->vertex_count * sizeof *mesh->positions);
    for (int32_t f = 0; f < hw->face_count; f++) {
        int32_t h = hw->face_half_edge[f];
        for (int corner = 0; corner < 3; corner++, h = hw->half_edges[h].next)
            mesh->triangles[3 * (int64_t)f + corner] = hw->half_edges[h].start;
        if (h != hw->face_half_edge[f]) {
            mesh_release(mesh);
            return error_set(err, "face %d is no triangle", f);
        }
    }
    return 0;
}
