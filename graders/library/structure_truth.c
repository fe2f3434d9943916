/* What faces say about connected structures: sides and their neighbours; see structure.h. */
#include "graders/library/structure.h"

#include "graders/library/sorting.h"

#include <inttypes.h>
#include <stdlib.h>

/* ---------------------------------------------------------------------------------------- sides */

static int64_t corner_count(const struct structure_truth *truth)
{
    return truth->topology.table.corner_count;
}

static bool is_outer(const struct structure_truth *truth, int64_t side)
{
    return side >= corner_count(truth);
}

int32_t structure_from(const struct structure_truth *truth, int64_t side)
{
    const struct face_topology *t = &truth->topology;
    int64_t corner = side;
    if (is_outer(truth, side))
        corner = topology_next(t, side - corner_count(truth));
    return t->table.corners[corner];
}

int64_t structure_twin(const struct structure_truth *truth, int64_t side)
{
    if (is_outer(truth, side))
        return side - corner_count(truth);
    int64_t twin = topology_twin(&truth->topology, side);
    return twin >= 0 ? twin : side + corner_count(truth);
}

int32_t structure_to(const struct structure_truth *truth, int64_t side)
{
    return structure_from(truth, structure_twin(truth, side));
}

int32_t structure_face(const struct structure_truth *truth, int64_t side)
{
    return is_outer(truth, side) ? STRUCTURE_NONE : truth->topology.corner_face[side];
}

/* A hole runs against the faces: what comes next there is the boundary side before. */
int64_t structure_next(const struct structure_truth *truth, int64_t side)
{
    const struct face_topology *t = &truth->topology;
    if (!is_outer(truth, side))
        return topology_next(t, side);
    int64_t vertex = topology_find_vertex(t, t->table.corners[side - corner_count(truth)]);
    return corner_count(truth) + truth->rim_ends_at[vertex];
}

int64_t structure_previous(const struct structure_truth *truth, int64_t side)
{
    const struct face_topology *t = &truth->topology;
    if (!is_outer(truth, side))
        return topology_previous(t, side);
    int64_t vertex = topology_find_vertex(t, structure_from(truth, side));
    return corner_count(truth) + truth->rim_starts_at[vertex];
}

int64_t structure_find_step(const struct structure_truth *truth, int32_t from, int32_t to)
{
    const struct face_topology *t = &truth->topology;
    int64_t edge = topology_find_edge(t, from, to);
    if (edge < 0)
        return -1;
    int64_t side = t->uses[t->edges[edge].first_use];
    return structure_from(truth, side) == from ? side : structure_twin(truth, side);
}

int64_t structure_find_corner(const struct structure_truth *truth, int32_t face, int32_t vertex)
{
    const struct face_topology *t = &truth->topology;
    if (face == STRUCTURE_NONE) {
        int64_t used = topology_find_vertex(t, vertex);
        bool has_hole = used >= 0 && truth->rim_ends_at[used] >= 0;
        return has_hole ? corner_count(truth) + truth->rim_ends_at[used] : -1;
    }
    if (face < 0 || face >= t->table.face_count)
        return -1;
    int64_t count, first = topology_face(t, face, &count), last = first + count, end = last;
    while (first < last) {
        int64_t middle = first + (last - first) / 2;
        if (t->table.corners[truth->by_face[middle]] < vertex)
            first = middle + 1;
        else
            last = middle;
    }
    bool is_there = first < end && t->table.corners[truth->by_face[first]] == vertex;
    return is_there ? truth->by_face[first] : -1;
}

/* ------------------------------------------------------------------------------------- building */

/* Lists the corners by vertex, and from that within each face. `filled` has an entry a face. */
static void index_corners(struct structure_truth *truth, uint64_t *words, uint64_t *spare,
                          int32_t *filled)
{
    const struct face_topology *t = &truth->topology;
    int64_t count = corner_count(truth), used = 0;
    for (int64_t c = 0; c < count; c++)
        words[c] = (uint64_t)(uint32_t)t->table.corners[c] << 32 | (uint64_t)c;
    sort_words(words, spare, count);
    for (int64_t i = 0; i < count; i++) {
        int32_t corner = (int32_t)(words[i] & UINT32_MAX), face = t->corner_face[corner];
        int64_t face_corners, first = topology_face(t, face, &face_corners);
        truth->by_vertex[i] = corner;
        truth->by_face[first + filled[face]++] = corner;
        if (i == 0 || words[i] >> 32 != words[i - 1] >> 32)
            truth->first_of[used++] = i;
    }
    truth->first_of[used] = count;
}

static void find_rims(struct structure_truth *truth)
{
    const struct face_topology *t = &truth->topology;
    for (int64_t v = 0; v < t->used_count; v++)
        truth->rim_starts_at[v] = truth->rim_ends_at[v] = -1;
    for (int64_t c = 0; c < corner_count(truth); c++) {
        if (topology_twin(t, c) >= 0)
            continue;
        int32_t from = t->table.corners[c], to = t->table.corners[topology_next(t, c)];
        truth->rim_starts_at[topology_find_vertex(t, from)] = (int32_t)c;
        truth->rim_ends_at[topology_find_vertex(t, to)] = (int32_t)c;
    }
}

static int refuse_faces(const struct face_topology *t, struct error *err)
{
    const char *why = NULL;
    int64_t covered = 0, count = 0;
    for (int64_t f = 0; t->broken.count == 0 && f < t->table.face_count; f++) {
        topology_face(t, f, &count);
        covered += count;
    }
    if (t->broken.count || t->degenerate.count || covered != t->table.corner_count)
        why = "a face is broken or degenerate";
    else if (!topology_is_manifold(t))
        why = "they are not manifold";
    else if (t->incoherent.count)
        why = "they are not coherent";
    return why ? error_set(err, "%" PRId64 " faces cannot be held by a connected structure: %s",
                           t->table.face_count, why)
               : 0;
}

int structure_truth_build(const struct face_table *faces, struct structure_truth *truth,
                          struct error *err)
{
    *truth = (struct structure_truth){0};
    if (topology_build(faces, &truth->topology, err))
        return -1;
    if (refuse_faces(&truth->topology, err)) {
        structure_truth_release(truth);
        return -1;
    }
    size_t corners = (size_t)faces->corner_count + 1;
    size_t used = (size_t)truth->topology.used_count + 1;
    truth->by_face = calloc(corners, sizeof *truth->by_face);
    truth->by_vertex = calloc(corners, sizeof *truth->by_vertex);
    truth->first_of = calloc(used, sizeof *truth->first_of);
    truth->rim_starts_at = calloc(used, sizeof *truth->rim_starts_at);
    truth->rim_ends_at = calloc(used, sizeof *truth->rim_ends_at);
    uint64_t *words = calloc(corners, sizeof *words), *spare = calloc(corners, sizeof *spare);
    int32_t *filled = calloc((size_t)faces->face_count + 1, sizeof *filled);
    bool has_memory = truth->by_face && truth->by_vertex && truth->first_of &&
                      truth->rim_starts_at && truth->rim_ends_at && words && spare && filled;
    if (has_memory) {
        index_corners(truth, words, spare, filled);
        find_rims(truth);
    } else {
        structure_truth_release(truth);
    }
    free(words);
    free(spare);
    free(filled);
    return has_memory
               ? 0
               : error_set(err, "out of memory: the sides of %" PRId64 " faces", faces->face_count);
}

void structure_truth_release(struct structure_truth *truth)
{
    topology_release(&truth->topology);
    free(truth->by_face);
    free(truth->by_vertex);
    free(truth->first_of);
    free(truth->rim_starts_at);
    free(truth->rim_ends_at);
    *truth = (struct structure_truth){0};
}
