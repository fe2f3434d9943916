/* Winged edges: building, checking, and back; see winged_edge.h. */
#include "reference/representation/winged_edge.h"

#include <stdlib.h>
#include <string.h>

/* -- storage -------------------------------------------------------------------------------- */

void winged_edge_release(struct winged_edge_mesh *we)
{
    free(we->positions);
    free(we->vertex_edge);
    free(we->face_edge);
    free(we->edges);
    *we = (struct winged_edge_mesh){0};
}

static int allocate(struct winged_edge_mesh *we, int32_t vertex_count, int32_t face_count,
                    int32_t edge_count, struct error *err)
{
    *we = (struct winged_edge_mesh){0};
    we->positions = malloc(3 * (size_t)vertex_count * sizeof *we->positions + 1);
    we->vertex_edge = malloc((size_t)vertex_count * sizeof *we->vertex_edge + 1);
    we->face_edge = malloc((size_t)face_count * sizeof *we->face_edge + 1);
    we->edges = calloc((size_t)edge_count + 1, sizeof *we->edges);
    if (!we->positions || !we->vertex_edge || !we->face_edge || !we->edges) {
        winged_edge_release(we);
        error_set(err, "out of memory: %d winged edges", edge_count);
        return -1;
    }
    we->vertex_count = we->vertex_capacity = vertex_count;
    we->face_count = we->face_capacity = face_count;
    we->edge_count = we->edge_capacity = edge_count;
    return 0;
}

/* -- building ------------------------------------------------------------------------------- */

/* Numbers the edges as reading the sides in order meets them. Returns how many there are. */
static int32_t edge_numbers_make(const int32_t *twin, int32_t side_count, int32_t *edge_of_side)
{
    int32_t count = 0;
    for (int32_t s = 0; s < side_count; s++)
        edge_of_side[s] = twin[s] >= 0 && twin[s] < s ? edge_of_side[twin[s]] : count++;
    return count;
}

/* The rows of the table, but for the links along holes. */
static void fill_faces(struct winged_edge_mesh *we, const struct polygons *polygons,
                       const int32_t *twin, const int32_t *edge_of_side)
{
    for (int32_t f = 0; f < polygons->face_count; f++) {
        int32_t first = polygons_start(polygons, f), last = polygons_start(polygons, f + 1) - 1;
        we->face_edge[f] = edge_of_side[first];
        for (int32_t s = first; s <= last; s++) {
            struct winged_edge *edge = we->edges + edge_of_side[s];
            int way = twin[s] >= 0 && twin[s] < s;
            edge->vertex[way] = polygons->corners[s];
            edge->face[way] = f;
            edge->previous[way] = edge_of_side[s == first ? last : s - 1];
            edge->next[way] = edge_of_side[s == last ? first : s + 1];
            if (twin[s] < 0) {
                edge->vertex[1] = polygons->corners[s == last ? first : s + 1];
                edge->face[1] = -1;
            }
        }
    }
}

/* At a vertex of one fan one boundary edge leaves forwards and one arrives, which are neighbours
 * along the hole; vertex_edge remembers the one that arrives meanwhile. */
static void fill_holes(struct winged_edge_mesh *we, const int32_t *edge_of_side, const int32_t *fan)
{
    for (int32_t e = 0; e < we->edge_count; e++)
        if (we->edges[e].face[1] < 0)
            we->vertex_edge[we->edges[e].vertex[1]] = e;
    for (int32_t e = 0; e < we->edge_count; e++) {
        struct winged_edge *edge = we->edges + e;
        if (edge->face[1] >= 0)
            continue;
        edge->next[1] = we->vertex_edge[edge->vertex[0]];
        edge->previous[1] = edge_of_side[fan[edge->vertex[1]]];
    }
}

static int build(struct winged_edge_mesh *we, const struct polygons *polygons,
                 const float *positions, int32_t *twin, int32_t *fan, int32_t *edge_of_side,
                 struct error *err)
{
    if (sides_match(polygons, twin, err) || sides_fans(polygons, twin, fan, err))
        return -1;
    int32_t edge_count = edge_numbers_make(twin, polygons_side_count(polygons), edge_of_side);
    if (allocate(we, polygons->vertex_count, polygons->face_count, edge_count, err))
        return -1;
    fill_faces(we, polygons, twin, edge_of_side);
    fill_holes(we, edge_of_side, fan);
    for (int32_t v = 0; v < we->vertex_count; v++)
        we->vertex_edge[v] = fan[v] < 0 ? -1 : edge_of_side[fan[v]];
    if (we->vertex_count)
        memcpy(we->positions, positions, 3 * (size_t)we->vertex_count * sizeof *positions);
    return 0;
}

int winged_edge_build(struct winged_edge_mesh *we, const struct polygons *polygons,
                      const float *positions, struct error *err)
{
    *we = (struct winged_edge_mesh){0};
    size_t side_count = (size_t)polygons_side_count(polygons);
    int32_t *twin = malloc(side_count * sizeof *twin + 1);
    int32_t *edge_of_side = calloc(side_count + 1, sizeof *edge_of_side);
    int32_t *fan = malloc((size_t)polygons->vertex_count * sizeof *fan + 1);
    int result =
        twin && edge_of_side && fan
            ? build(we, polygons, positions, twin, fan, edge_of_side, err)
            : error_set(err, "out of memory: winged edges of %d faces", polygons->face_count);
    free(twin);
    free(edge_of_side);
    free(fan);
    return result;
}

/* -- checking ------------------------------------------------------------------------------- */

static bool in_use(const struct winged_edge_mesh *we, int32_t edge)
{
    return edge >= 0 && edge < we->edge_count && we->edges[edge].vertex[0] >= 0;
}

static bool has_vertex(const struct winged_edge_mesh *we, int32_t edge, int32_t vertex)
{
    return we->edges[edge].vertex[0] == vertex || we->edges[edge].vertex[1] == vertex;
}

/* The ends and faces of an edge, and that its links name edges. */
static int check_fields(const struct winged_edge_mesh *we, int32_t e, struct error *err)
{
    const struct winged_edge *edge = we->edges + e;
    for (int way = 0; way < 2; way++) {
        int32_t v = edge->vertex[way], f = edge->face[way];
        if (v < 0 || v >= we->vertex_count || we->vertex_edge[v] < 0)
            return error_set(err, "edge %d has vertex %d, which is none in use", e, v);
        if (f < -1 || f >= we->face_count || (f >= 0 && we->face_edge[f] < 0))
            return error_set(err, "edge %d has face %d, which is none", e, f);
        if (!in_use(we, edge->next[way]) || !in_use(we, edge->previous[way]))
            return error_set(err, "edge %d has neighbours %d and %d, not both edges", e,
                             edge->previous[way], edge->next[way]);
    }
    if (edge->vertex[0] == edge->vertex[1])
        return error_set(err, "edge %d has vertex %d at both ends", e, edge->vertex[0]);
    if (edge->face[0] == edge->face[1])
        return error_set(err, "edge %d has face %d on both sides", e, edge->face[0]);
    return 0;
}

/* That each side and the next agree. */
static int check_links(const struct winged_edge_mesh *we, int32_t e, struct error *err)
{
    for (int way = 0; way < 2; way++) {
        struct winged_side side = {e, way};
        int32_t end = winged_edge_end(we, side), start = winged_edge_start(we, side);
        int32_t next_edge = we->edges[e].next[way], previous_edge = we->edges[e].previous[way];
        if (!has_vertex(we, next_edge, end))
            return error_set(err, "edge %d: its next edge %d does not leave vertex %d", e,
                             next_edge, end);
        if (!has_vertex(we, previous_edge, start))
            return error_set(err, "edge %d: its previous edge %d does not reach vertex %d", e,
                             previous_edge, start);
        struct winged_side next = winged_edge_next(we, side);
        if (winged_edge_face(we, next) != we->edges[e].face[way])
            return error_set(err, "edge %d has face %d, its next edge %d there has face %d", e,
                             we->edges[e].face[way], next.edge, winged_edge_face(we, next));
        if (we->edges[next.edge].previous[next.way] != e)
            return error_set(err, "edge %d: its next edge %d has previous edge %d", e, next.edge,
                             we->edges[next.edge].previous[next.way]);
    }
    return 0;
}

/* Follows the cycle of `first`, marks what it meets, and returns its length; -1 when it runs into a
 * side marked before. */
static int32_t mark_cycle(const struct winged_edge_mesh *we, struct winged_side first,
                          bool around_vertex, uint8_t *marked)
{
    int32_t length = 0;
    struct winged_side side = first;
    do {
        uint8_t *mark = marked + 2 * (int64_t)side.edge + side.way;
        if (*mark)
            return -1;
        *mark = 1;
        length++;
        side = around_vertex ? winged_edge_turn_left(we, side) : winged_edge_next(we, side);
    } while (side.edge != first.edge || side.way != first.way);
    return length;
}

static int check_faces(const struct winged_edge_mesh *we, uint8_t *marked, struct error *err)
{
    for (int32_t f = 0; f < we->face_count; f++) {
        int32_t e = we->face_edge[f];
        if (e == WINGED_EDGE_REMOVED)
            continue;
        if (!in_use(we, e) || (we->edges[e].face[0] != f && we->edges[e].face[1] != f))
            return error_set(err, "face %d has edge %d, which is not one of its own", f, e);
        if (mark_cycle(we, winged_edge_of_face(we, f), false, marked) < 3)
            return error_set(err, "face %d has edges that are no cycle of 3 or more", f);
    }
    for (int32_t e = 0; e < we->edge_count; e++)
        for (int way = 0; way < 2 && we->edges[e].vertex[0] >= 0; way++) {
            struct winged_side side = {e, way};
            if (marked[2 * (int64_t)e + way])
                continue;
            if (winged_edge_face(we, side) >= 0)
                return error_set(err, "edge %d is not in the cycle of its face %d", e,
                                 winged_edge_face(we, side));
            if (mark_cycle(we, side, false, marked) < 0)
                return error_set(err, "edge %d is not in a boundary loop", e);
        }
    return 0;
}

static int check_vertices(const struct winged_edge_mesh *we, uint8_t *marked, struct error *err)
{
    for (int32_t v = 0; v < we->vertex_count; v++) {
        int32_t e = we->vertex_edge[v];
        if (e == WINGED_EDGE_REMOVED || e == -1)
            continue;
        if (!in_use(we, e) || !has_vertex(we, e, v))
            return error_set(err, "vertex %d has edge %d, which is not at it", v, e);
        if (mark_cycle(we, winged_edge_of_vertex(we, v), true, marked) < 0)
            return error_set(err, "vertex %d: the edges around it are no cycle", v);
    }
    for (int32_t e = 0; e < we->edge_count; e++)
        for (int way = 0; way < 2 && we->edges[e].vertex[0] >= 0; way++) {
            int32_t v = we->edges[e].vertex[way];
            if (!marked[2 * (int64_t)e + way])
                return error_set(err, "vertex %d is non-manifold: edge %d is in another fan", v, e);
            if (we->edges[e].face[1 - way] < 0 && we->vertex_edge[v] != e)
                return error_set(err, "vertex %d is on the boundary: it should have edge %d", v, e);
        }
    return 0;
}

int winged_edge_check(const struct winged_edge_mesh *we, struct error *err)
{
    for (int32_t e = 0; e < we->edge_count; e++)
        if (we->edges[e].vertex[0] != WINGED_EDGE_REMOVED && check_fields(we, e, err))
            return -1;
    for (int32_t e = 0; e < we->edge_count; e++)
        if (we->edges[e].vertex[0] != WINGED_EDGE_REMOVED && check_links(we, e, err))
            return -1;
    uint8_t *marked = calloc(4 * (size_t)we->edge_count + 1, 1);
    if (!marked)
        return error_set(err, "out of memory: checking %d winged edges", we->edge_count);
    int result = check_faces(we, marked, err);
    if (!result)
        result = check_vertices(we, marked + 2 * (int64_t)we->edge_count, err);
    free(marked);
    return result;
}

/* -- back to an indexed mesh, and search ---------------------------------------------------- */

int winged_edge_to_mesh(const struct winged_edge_mesh *we, struct mesh *mesh, struct error *err)
{
    if (mesh_init(mesh, we->vertex_count, we->face_count, err))
        return -1;
    if (we->vertex_count)
        memcpy(mesh->positions, we->positions,
               3 * (size_t)we->vertex_count * sizeof *mesh->positions);
    for (int32_t f = 0; f < we->face_count; f++) {
        if (we->face_edge[f] >= 0) {
            struct winged_side first = winged_edge_of_face(we, f), side = first;
            for (int corner = 0; corner < 3; corner++, side = winged_edge_next(we, side))
                mesh->triangles[3 * (int64_t)f + corner] = winged_edge_start(we, side);
            if (side.edge == first.edge && side.way == first.way)
                continue;
        }
        mesh_release(mesh);
        error_set(err, "face %d is no triangle", f);
        return -1;
    }
    return 0;
}

int32_t winged_edge_find(const struct winged_edge_mesh *we, int32_t u, int32_t v)
{
    if (we->vertex_edge[u] < 0)
        return -1;
    struct winged_side first = winged_edge_of_vertex(we, u), side = first;
    do {
        if (winged_edge_end(we, side) == v)
            return side.edge;
        side = winged_edge_turn_left(we, side);
    } while (side.edge != first.edge);
    return -1;
}
