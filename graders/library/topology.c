/* The topology of faces: corners, vertices and edges; see topology.h. Fans, components, loops and
 * orientation: topology_groups.c. */
#include "graders/library/topology.h"

#include "graders/library/sorting.h"
#include "graders/library/topology_groups.h"

#include <inttypes.h>
#include <stdlib.h>

static const struct finding nothing_found = {0, -1};

static void note(struct finding *found, int64_t element)
{
    if (found->count++ == 0)
        found->first = element;
}

/* -------------------------------------------------------------------------------------- corners */

int64_t topology_face(const struct face_topology *t, int64_t face, int64_t *count)
{
    const int32_t *starts = t->table.starts;
    *count = starts ? (int64_t)starts[face + 1] - starts[face] : 3;
    return starts ? starts[face] : 3 * face;
}

int64_t topology_next(const struct face_topology *t, int64_t corner)
{
    int64_t count, first = topology_face(t, t->corner_face[corner], &count);
    return corner + 1 == first + count ? first : corner + 1;
}

int64_t topology_previous(const struct face_topology *t, int64_t corner)
{
    int64_t count, first = topology_face(t, t->corner_face[corner], &count);
    return corner == first ? first + count - 1 : corner - 1;
}

/* What is wrong with a face; *corner is the first index out of range. */
static enum face_flaw flaw_of_face(const struct face_table *table, int64_t face, int64_t *corner)
{
    *corner = -1;
    int64_t first = table->starts ? table->starts[face] : 3 * face;
    int64_t end = table->starts ? table->starts[face + 1] : first + 3;
    bool is_late = face == 0 && first > 0;
    if (first < 0 || is_late || end < first || end > table->corner_count)
        return FACE_BAD_OFFSETS;
    if (end - first < 3)
        return FACE_TOO_FEW_CORNERS;
    for (int64_t c = first; c < end; c++)
        if (table->corners[c] < 0 || table->corners[c] >= table->vertex_count) {
            *corner = c;
            return FACE_INDEX_OUT_OF_RANGE;
        }
    return FACE_FINE;
}

static void note_flaw(struct face_topology *t, int64_t face, enum face_flaw flaw, int64_t corner)
{
    if (t->broken.count == 0) {
        t->flaw = flaw;
        t->flaw_corner = corner;
    }
    note(&t->broken, face);
}

/* Gives the corners of faces that are not broken to these. Where an offset leads back, corners that
 * belong to an earlier face break the later one. */
static void assign_corners(struct face_topology *t)
{
    for (int64_t c = 0; c < t->table.corner_count; c++)
        t->corner_face[c] = -1;
    int64_t taken = 0; /* corners before this one belong to faces already */
    for (int64_t face = 0; face < t->table.face_count; face++) {
        int64_t corner, count;
        enum face_flaw flaw = flaw_of_face(&t->table, face, &corner);
        if (flaw == FACE_FINE && topology_face(t, face, &count) < taken)
            flaw = FACE_BAD_OFFSETS;
        t->component[face] = flaw == FACE_FINE ? 0 : -1;
        if (flaw != FACE_FINE) {
            note_flaw(t, face, flaw, corner);
            continue;
        }
        int64_t first = topology_face(t, face, &count);
        for (int64_t c = first; c < first + count; c++)
            t->corner_face[c] = (int32_t)face;
        taken = first + count;
    }
}

/* ------------------------------------------------------------------------------------- vertices */

/* The corners of faces that are not broken, by vertex: word = vertex, corner. */
static int64_t sort_corners(const struct face_topology *t, uint64_t *words, uint64_t *spare)
{
    int64_t count = 0;
    for (int64_t c = 0; c < t->table.corner_count; c++)
        if (t->corner_face[c] >= 0)
            words[count++] = (uint64_t)(uint32_t)t->table.corners[c] << 32 | (uint64_t)c;
    sort_words(words, spare, count);
    return count;
}

/* Corners of one face at one vertex stand together: the face is degenerate. */
static void find_degenerate(struct face_topology *t, const uint64_t *words, int64_t count)
{
    for (int64_t i = 1; i < count; i++) {
        int32_t face = t->corner_face[words[i] & UINT32_MAX];
        bool is_again = words[i] >> 32 == words[i - 1] >> 32 &&
                        face == t->corner_face[words[i - 1] & UINT32_MAX];
        if (is_again)
            t->patch[face] = -1;
    }
    for (int64_t face = 0; face < t->table.face_count; face++) {
        if (t->component[face] < 0)
            continue;
        if (t->patch[face] < 0)
            note(&t->degenerate, face);
        else
            t->proper_count++;
    }
}

/* Lists the used vertices; of_corner[c] becomes the index of corner c's. */
static void list_vertices(struct face_topology *t, const uint64_t *words, int64_t count,
                          int32_t *of_corner)
{
    for (int64_t i = 0; i < count; i++) {
        int64_t corner = (int64_t)(words[i] & UINT32_MAX);
        if (i == 0 || words[i] >> 32 != words[i - 1] >> 32)
            t->vertices[t->used_count++] =
                (struct face_vertex){.vertex = t->table.corners[corner], .is_manifold = true};
        of_corner[corner] = (int32_t)(t->used_count - 1);
    }
}

/* From here on only the corners of proper faces have a face. */
static void forget_degenerate(struct face_topology *t, const int32_t *of_corner)
{
    for (int64_t c = 0; c < t->table.corner_count; c++) {
        int32_t face = t->corner_face[c];
        if (face >= 0 && t->patch[face] < 0)
            t->corner_face[c] = -1;
        else if (face >= 0)
            t->vertices[of_corner[c]].face_count++;
    }
}

/* ---------------------------------------------------------------------------------------- edges */

static bool runs_up(const struct face_topology *t, int64_t side)
{
    return t->table.corners[side] < t->table.corners[topology_next(t, side)];
}

/* The sides by their smaller and larger vertex; stable, so by number for one edge. Two sortings:
 * the second is by the smaller one, of sides that the first has in order. */
static int64_t sort_sides(struct face_topology *t, uint64_t *words, uint64_t *spare)
{
    int64_t count = 0;
    for (int64_t c = 0; c < t->table.corner_count; c++)
        if (t->corner_face[c] >= 0) {
            int64_t next = topology_next(t, c);
            int32_t high = t->table.corners[runs_up(t, c) ? next : c];
            words[count++] = (uint64_t)(uint32_t)high << 32 | (uint64_t)c;
        }
    sort_words(words, spare, count);
    for (int64_t i = 0; i < count; i++) {
        int64_t side = (int64_t)(words[i] & UINT32_MAX);
        int64_t low_end = runs_up(t, side) ? side : topology_next(t, side);
        t->uses[i] = (int32_t)side;
        words[i] = (uint64_t)(uint32_t)t->table.corners[low_end] << 32 | (uint64_t)i;
    }
    sort_words(words, spare, count);
    for (int64_t i = 0; i < count; i++)
        words[i] = (uint64_t)t->uses[words[i] & UINT32_MAX];
    for (int64_t i = 0; i < count; i++)
        t->uses[i] = (int32_t)words[i];
    return count;
}

static void list_edges(struct face_topology *t, int64_t use_count)
{
    for (int64_t c = 0; c < t->table.corner_count; c++)
        t->side_edge[c] = -1;
    for (int64_t i = 0; i < use_count; i++) {
        int64_t side = t->uses[i];
        bool up = runs_up(t, side);
        int32_t from = t->table.corners[side], to = t->table.corners[topology_next(t, side)];
        int32_t low = up ? from : to, high = up ? to : from;
        const struct face_edge *last = t->edge_count > 0 ? t->edges + t->edge_count - 1 : t->edges;
        if (t->edge_count == 0 || last->low != low || last->high != high)
            t->edges[t->edge_count++] =
                (struct face_edge){.low = low, .high = high, .first_use = i};
        struct face_edge *edge = t->edges + t->edge_count - 1;
        edge->up_count += up;
        edge->down_count += !up;
        t->side_edge[side] = (int32_t)(t->edge_count - 1);
    }
    for (int64_t e = 0; e < t->edge_count; e++) {
        int64_t sides = topology_side_count(&t->edges[e]);
        if (sides == 1)
            note(&t->boundary, e);
        else if (sides > 2)
            note(&t->nonmanifold_edge, e);
        else if (t->edges[e].up_count != 1)
            note(&t->incoherent, e);
    }
}

int64_t topology_find_edge(const struct face_topology *t, int32_t a, int32_t b)
{
    int32_t low = a < b ? a : b, high = a < b ? b : a;
    int64_t first = 0, last = t->edge_count;
    while (first < last) {
        int64_t middle = first + (last - first) / 2;
        const struct face_edge *edge = &t->edges[middle];
        if (edge->low < low || (edge->low == low && edge->high < high))
            first = middle + 1;
        else
            last = middle;
    }
    bool is_there =
        first < t->edge_count && t->edges[first].low == low && t->edges[first].high == high;
    return is_there ? first : -1;
}

int64_t topology_find_vertex(const struct face_topology *t, int32_t vertex)
{
    int64_t first = 0, last = t->used_count;
    while (first < last) {
        int64_t middle = first + (last - first) / 2;
        if (t->vertices[middle].vertex < vertex)
            first = middle + 1;
        else
            last = middle;
    }
    return first < t->used_count && t->vertices[first].vertex == vertex ? first : -1;
}

int64_t topology_twin(const struct face_topology *t, int64_t side)
{
    const struct face_edge *edge = t->side_edge[side] < 0 ? NULL : &t->edges[t->side_edge[side]];
    if (!edge || topology_side_count(edge) != 2)
        return -1;
    return t->uses[edge->first_use] == side ? t->uses[edge->first_use + 1]
                                            : t->uses[edge->first_use];
}

int32_t topology_edge_face(const struct face_topology *t, int64_t edge, int64_t i)
{
    return t->corner_face[t->uses[t->edges[edge].first_use + i]];
}

/* ------------------------------------------------------------------------------------ the whole */

bool topology_is_manifold(const struct face_topology *t)
{
    return t->nonmanifold_edge.count == 0 && t->nonmanifold_vertex.count == 0;
}

int64_t topology_euler(const struct face_topology *t)
{
    return t->used_count - t->edge_count + t->proper_count;
}

int64_t topology_genus(const struct face_topology *t)
{
    if (t->broken.count || t->degenerate.count || !topology_is_manifold(t) || t->unorientable.count)
        return -1;
    return t->component_count - (topology_euler(t) + t->loop_count) / 2;
}

void topology_release(struct face_topology *t)
{
    free(t->corner_face);
    free(t->vertices);
    free(t->edges);
    free(t->uses);
    free(t->side_edge);
    free(t->component);
    free(t->patch);
    free(t->loop_first);
    free(t->loop_vertices);
    *t = (struct face_topology){0};
}

static bool reserve_tables(struct face_topology *t)
{
    size_t corners = (size_t)t->table.corner_count + 1, faces = (size_t)t->table.face_count + 1;
    t->corner_face = calloc(corners, sizeof *t->corner_face);
    t->vertices = calloc(corners, sizeof *t->vertices);
    t->edges = calloc(corners, sizeof *t->edges);
    t->uses = calloc(corners, sizeof *t->uses);
    t->side_edge = calloc(corners, sizeof *t->side_edge);
    t->component = calloc(faces, sizeof *t->component);
    t->patch = calloc(faces, sizeof *t->patch);
    return t->corner_face && t->vertices && t->edges && t->uses && t->side_edge && t->component &&
           t->patch;
}

/* Fills everything but what topology_groups.c does. */
static void build_tables(struct face_topology *t, int32_t *of_corner, uint64_t *words,
                         uint64_t *spare)
{
    assign_corners(t);
    int64_t count = sort_corners(t, words, spare);
    find_degenerate(t, words, count);
    list_vertices(t, words, count, of_corner);
    forget_degenerate(t, of_corner);
    list_edges(t, sort_sides(t, words, spare));
}

int topology_build(const struct face_table *faces, struct face_topology *t, struct error *err)
{
    *t = (struct face_topology){.table = *faces,
                                .flaw_corner = -1,
                                .broken = nothing_found,
                                .degenerate = nothing_found,
                                .boundary = nothing_found,
                                .nonmanifold_edge = nothing_found,
                                .incoherent = nothing_found,
                                .nonmanifold_vertex = nothing_found,
                                .unorientable = nothing_found};
    if (faces->face_count < 0 || faces->face_count >= INT32_MAX || faces->corner_count < 0 ||
        faces->corner_count >= INT32_MAX)
        return error_set(err, "%" PRId64 " faces with %" PRId64 " corners have no topology here",
                         faces->face_count, faces->corner_count);
    size_t corners = (size_t)faces->corner_count + 1;
    int32_t *of_corner = calloc(corners, sizeof *of_corner);
    uint64_t *words = calloc(corners, sizeof *words);
    uint64_t *spare = calloc(corners, sizeof *spare);
    bool has_memory = of_corner && words && spare && reserve_tables(t);
    int failed = 0;
    if (has_memory)
        build_tables(t, of_corner, words, spare);
    else
        failed =
            error_set(err, "out of memory: the topology of %" PRId64 " faces", faces->face_count);
    free(words);
    free(spare);
    if (!failed)
        failed = topology_join_groups(t, of_corner, err);
    free(of_corner);
    if (failed)
        topology_release(t);
    return failed;
}
