/* Components, patches, orientation, fans and loops; see topology_groups.h. */
#include "graders/library/topology_groups.h"

#include "reference/mesh/groups.h"

#include <inttypes.h>
#include <stdlib.h>

static void note(struct finding *found, int64_t element)
{
    if (found->count++ == 0)
        found->first = element;
}

static int out_of_memory(const struct face_topology *t, struct error *err)
{
    return error_set(err, "out of memory: the topology of %" PRId64 " faces", t->table.face_count);
}

/* ------------------------------------------------------------------------ components and patches
 */

/* Numbers groups in the order of the faces. stands_for[f] is the thing that a face belongs to, and
 * labels[f] is not negative where it belongs to any. Returns how many groups there are; -1 when
 * memory runs out. */
static int64_t label_faces(const struct face_topology *t, struct groups *groups,
                           int64_t thing_count, const int32_t *stands_for, int32_t *labels)
{
    int32_t *label_of_root = calloc((size_t)thing_count + 1, sizeof *label_of_root);
    if (!label_of_root)
        return -1;
    int32_t count = 0;
    for (int64_t f = 0; f < t->table.face_count; f++) {
        if (labels[f] < 0)
            continue;
        int32_t root = groups_root(groups, stands_for ? stands_for[f] : (int32_t)f);
        if (label_of_root[root] == 0)
            label_of_root[root] = ++count;
        labels[f] = label_of_root[root] - 1;
    }
    free(label_of_root);
    return count;
}

static void label_vertices(struct face_topology *t, const int32_t *of_corner)
{
    for (int64_t f = 0; f < t->table.face_count; f++) {
        if (t->component[f] < 0)
            continue;
        int64_t count, first = topology_face(t, f, &count);
        for (int64_t c = first; c < first + count; c++)
            t->vertices[of_corner[c]].component = t->component[f];
    }
}

/* Faces that share a vertex, degenerate ones too. */
static int join_components(struct face_topology *t, const int32_t *of_corner, struct error *err)
{
    struct groups vertices;
    if (groups_init(&vertices, t->used_count, err))
        return -1;
    int32_t *stands_for = calloc((size_t)t->table.face_count + 1, sizeof *stands_for);
    t->component_count = -1;
    for (int64_t f = 0; stands_for && f < t->table.face_count; f++) {
        if (t->component[f] < 0)
            continue;
        int64_t count, first = topology_face(t, f, &count);
        stands_for[f] = of_corner[first];
        for (int64_t c = first + 1; c < first + count; c++)
            groups_join(&vertices, of_corner[first], of_corner[c]);
    }
    if (stands_for)
        t->component_count = label_faces(t, &vertices, t->used_count, stands_for, t->component);
    if (t->component_count >= 0)
        label_vertices(t, of_corner);
    free(stands_for);
    groups_release(&vertices);
    return t->component_count < 0 ? out_of_memory(t, err) : 0;
}

/* Proper faces that share an edge. */
static int join_patches(struct face_topology *t, struct error *err)
{
    struct groups faces;
    if (groups_init(&faces, t->table.face_count, err))
        return -1;
    for (int64_t e = 0; e < t->edge_count; e++)
        for (int64_t i = 1; i < topology_side_count(&t->edges[e]); i++)
            groups_join(&faces, topology_edge_face(t, e, 0), topology_edge_face(t, e, i));
    for (int64_t f = 0; f < t->table.face_count; f++)
        if (t->component[f] < 0)
            t->patch[f] = -1; /* broken; degenerate ones are marked already */
    t->patch_count = label_faces(t, &faces, t->table.face_count, NULL, t->patch);
    groups_release(&faces);
    return t->patch_count < 0 ? out_of_memory(t, err) : 0;
}

static int join_windings(struct face_topology *t, struct error *err)
{
    struct groups faces;
    if (groups_init(&faces, t->table.face_count, err))
        return -1;
    for (int64_t e = 0; e < t->edge_count; e++)
        if (topology_side_count(&t->edges[e]) == 2 &&
            !groups_join_parity(&faces, topology_edge_face(t, e, 0), topology_edge_face(t, e, 1),
                                t->edges[e].up_count != 1))
            note(&t->unorientable, e);
    groups_release(&faces);
    return 0;
}

/* ----------------------------------------------------------------------------------------- fans */

/* The corner at which a side touches a vertex. */
static int32_t corner_at(const struct face_topology *t, int32_t side, int32_t vertex)
{
    return t->table.corners[side] == vertex ? side : (int32_t)topology_next(t, side);
}

/* Corners at one vertex hang together by an edge there. Each edge that joins two groups of them
 * leaves one fan less. */
static void join_at_edge(struct face_topology *t, const struct face_edge *edge,
                         const int32_t *of_corner, struct groups *corners)
{
    const int32_t *uses = t->uses + edge->first_use;
    int64_t sides = topology_side_count(edge);
    for (int end = 0; end < 2; end++) {
        int32_t number = end == 0 ? edge->low : edge->high;
        int32_t corner = corner_at(t, uses[0], number);
        struct face_vertex *vertex = &t->vertices[of_corner[corner]];
        vertex->boundary_count += sides == 1;
        vertex->is_manifold = vertex->is_manifold && sides <= 2;
        for (int64_t i = 1; i < sides; i++)
            vertex->fan_count -= groups_join(corners, corner, corner_at(t, uses[i], number));
    }
}

/* First what edges of two sides join, then what the others do. */
static void join_corners(struct face_topology *t, const int32_t *of_corner, struct groups *corners)
{
    for (int64_t v = 0; v < t->used_count; v++)
        t->vertices[v].fan_count = t->vertices[v].face_count;
    for (int64_t e = 0; e < t->edge_count; e++)
        if (topology_side_count(&t->edges[e]) <= 2)
            join_at_edge(t, &t->edges[e], of_corner, corners);
    for (int64_t v = 0; v < t->used_count; v++)
        t->vertices[v].sheet_count = t->vertices[v].fan_count;
    for (int64_t e = 0; e < t->edge_count; e++)
        if (topology_side_count(&t->edges[e]) > 2)
            join_at_edge(t, &t->edges[e], of_corner, corners);
    for (int64_t v = 0; v < t->used_count; v++) {
        struct face_vertex *vertex = &t->vertices[v];
        vertex->is_manifold = vertex->is_manifold && vertex->fan_count <= 1;
        if (!vertex->is_manifold)
            note(&t->nonmanifold_vertex, v);
    }
}

/* ---------------------------------------------------------------------------------------- loops */

/* The sides of boundary edges, by number, and how they follow each other. An end is 2b where side b
 * starts and 2b + 1 where it ends. */
struct rim {
    int32_t *sides;
    int32_t count;
    int32_t *next;  /* of each end: the other end of the same fan */
    int32_t *first; /* of each fan, by its root corner: 1 + the first end found there; 0: none */
    uint8_t *is_done;
};

static int32_t corner_of_end(const struct face_topology *t, const struct rim *rim, int32_t end)
{
    int32_t side = rim->sides[end / 2];
    return end % 2 == 0 ? side : (int32_t)topology_next(t, side);
}

/* Joins the ends that lie in one fan. Returns how many groups of sides come out. */
static int64_t join_ends(const struct face_topology *t, struct groups *corners,
                         struct groups *sides, struct rim *rim)
{
    int64_t group_count = rim->count;
    for (int32_t end = 0; end < 2 * rim->count; end++) {
        int32_t root = groups_root(corners, corner_of_end(t, rim, end));
        if (rim->first[root] == 0) {
            rim->first[root] = end + 1;
            continue;
        }
        int32_t other = rim->first[root] - 1;
        rim->next[end] = other;
        rim->next[other] = end;
        group_count -= groups_join(sides, end / 2, other / 2);
    }
    return group_count;
}

static void walk_loops(struct face_topology *t, struct rim *rim)
{
    int32_t vertex_count = 0;
    int64_t loop = 0;
    for (int32_t b = 0; b < rim->count; b++) {
        if (rim->is_done[b])
            continue;
        t->loop_first[loop++] = vertex_count;
        for (int32_t end = 2 * b; !rim->is_done[end / 2]; end = rim->next[end ^ 1]) {
            rim->is_done[end / 2] = 1;
            t->loop_vertices[vertex_count++] = t->table.corners[corner_of_end(t, rim, end)];
        }
    }
    t->loop_first[loop] = vertex_count;
}

static void list_boundary_sides(const struct face_topology *t, struct rim *rim)
{
    for (int32_t c = 0; c < t->table.corner_count; c++)
        if (t->side_edge[c] >= 0 && topology_side_count(&t->edges[t->side_edge[c]]) == 1)
            rim->sides[rim->count++] = c;
}

static int find_loops(struct face_topology *t, struct groups *corners, struct error *err)
{
    struct groups sides;
    size_t room = (size_t)t->boundary.count + 1;
    if (groups_init(&sides, t->boundary.count, err))
        return -1;
    struct rim rim = {.sides = calloc(room, sizeof *rim.sides),
                      .next = calloc(2 * room, sizeof *rim.next),
                      .first = calloc((size_t)t->table.corner_count + 1, sizeof *rim.first),
                      .is_done = calloc(room, 1)};
    bool can_walk = t->nonmanifold_edge.count == 0;
    if (can_walk) {
        t->loop_first = calloc(room, sizeof *t->loop_first);
        t->loop_vertices = calloc(room, sizeof *t->loop_vertices);
    }
    bool has_memory = rim.sides && rim.next && rim.first && rim.is_done &&
                      (!can_walk || (t->loop_first && t->loop_vertices));
    if (has_memory) {
        list_boundary_sides(t, &rim);
        t->loop_count = join_ends(t, corners, &sides, &rim);
        if (can_walk)
            walk_loops(t, &rim);
    }
    free(rim.sides);
    free(rim.next);
    free(rim.first);
    free(rim.is_done);
    groups_release(&sides);
    return has_memory ? 0 : out_of_memory(t, err);
}

int topology_join_groups(struct face_topology *t, const int32_t *of_corner, struct error *err)
{
    if (join_components(t, of_corner, err) || join_patches(t, err) || join_windings(t, err))
        return -1;
    struct groups corners;
    if (groups_init(&corners, t->table.corner_count, err))
        return -1;
    join_corners(t, of_corner, &corners);
    int failed = find_loops(t, &corners, err);
    groups_release(&corners);
    return failed;
}
