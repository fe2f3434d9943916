/* Edits of half edges, each a rewiring of a few rows; see half_edge_edit.h for the pictures. */
#include "reference/representation/half_edge_edit.h"

#include <stdlib.h>
#include <string.h>

/* -- room ----------------------------------------------------------------------------------- */

/* Room for `more` elements of `size` bytes; grows by half at least. Returns false without memory.
 */
static bool grow(void **table, int32_t *capacity, int64_t wanted, size_t size)
{
    if (wanted <= *capacity)
        return true;
    int64_t larger = *capacity + (int64_t)*capacity / 2;
    larger = larger < wanted ? wanted : larger > INT32_MAX ? INT32_MAX : larger;
    void *grown = realloc(*table, (size_t)larger * size);
    if (!grown)
        return false;
    *table = grown;
    *capacity = (int32_t)larger;
    return true;
}

static bool grow_vertices(struct half_edge_mesh *he, int64_t wanted)
{
    void *positions = he->positions, *links = he->vertex_half_edge;
    int32_t positions_capacity = he->vertex_capacity, links_capacity = he->vertex_capacity;
    bool done = grow(&positions, &positions_capacity, wanted, 3 * sizeof *he->positions) &&
                grow(&links, &links_capacity, wanted, sizeof *he->vertex_half_edge);
    he->positions = positions;
    he->vertex_half_edge = links;
    if (done)
        he->vertex_capacity = links_capacity;
    return done;
}

int half_edge_reserve(struct half_edge_mesh *he, int64_t more_vertices, int64_t more_faces,
                      int64_t more_half_edges, struct error *err)
{
    int64_t vertices = he->vertex_count + more_vertices, faces = he->face_count + more_faces;
    int64_t half_edges = he->half_edge_count + more_half_edges;
    if (vertices > INT32_MAX || faces > INT32_MAX || half_edges > INT32_MAX)
        return error_set(err, "%lld half edges are more than an int32 can number",
                         (long long)half_edges);
    void *rows = he->half_edges, *links = he->face_half_edge;
    bool done = grow(&rows, &he->half_edge_capacity, half_edges, sizeof *he->half_edges) &&
                grow(&links, &he->face_capacity, faces, sizeof *he->face_half_edge) &&
                grow_vertices(he, vertices);
    he->half_edges = rows;
    he->face_half_edge = links;
    return done ? 0 : error_set(err, "out of memory: %lld half edges", (long long)half_edges);
}

/* -- rewiring ------------------------------------------------------------------------------- */

static void set_half_edge(struct half_edge_mesh *he, int32_t h, int32_t origin, int32_t twin)
{
    he->half_edges[h].origin = origin;
    he->half_edges[h].twin = twin;
}

static void set_triangle(struct half_edge_mesh *he, int32_t face, int32_t a, int32_t b, int32_t c)
{
    struct half_edge *half_edges = he->half_edges;
    half_edges[a].next = b;
    half_edges[b].next = c;
    half_edges[c].next = a;
    half_edges[a].face = half_edges[b].face = half_edges[c].face = face;
    he->face_half_edge[face] = a;
}

static int32_t add_vertex(struct half_edge_mesh *he, const float position[3], int32_t half_edge)
{
    int32_t vertex = he->vertex_count++;
    memcpy(he->positions + 3 * (int64_t)vertex, position, 3 * sizeof *position);
    he->vertex_half_edge[vertex] = half_edge;
    return vertex;
}

/* -- splits --------------------------------------------------------------------------------- */

int32_t half_edge_split_face(struct half_edge_mesh *he, int32_t face, const float position[3],
                             struct error *err)
{
    if (half_edge_reserve(he, 1, 2, 6, err))
        return -1;
    int32_t sides[3] = {he->face_half_edge[face], 0, 0};
    sides[1] = he->half_edges[sides[0]].next;
    sides[2] = he->half_edges[sides[1]].next;
    /* first + 2 i runs from corner i to the middle, first + 2 i + 1 back */
    int32_t first = he->half_edge_count, middle = add_vertex(he, position, first + 1);
    he->half_edge_count += 6;
    he->face_count += 2;
    for (int i = 0; i < 3; i++) {
        set_half_edge(he, first + 2 * i, he->half_edges[sides[i]].origin, first + 2 * i + 1);
        set_half_edge(he, first + 2 * i + 1, middle, first + 2 * i);
    }
    for (int i = 0; i < 3; i++)
        set_triangle(he, i == 0 ? face : he->face_count - 3 + i, sides[i],
                     first + 2 * ((i + 1) % 3), first + 2 * i + 1);
    return middle;
}

/* The triangle of h = u -> m, which was u -> v, becomes two; `rest` is m -> v, and `in`, `out` join
 * the opposite corner and m. */
static void split_beside(struct half_edge_mesh *he, int32_t h, int32_t rest, int32_t in,
                         int32_t out, int32_t middle)
{
    int32_t second = he->half_edges[h].next, third = he->half_edges[second].next;
    set_half_edge(he, in, he->half_edges[third].origin, out);
    set_half_edge(he, out, middle, in);
    set_triangle(he, he->half_edges[h].face, h, out, third);
    set_triangle(he, he->face_count++, rest, second, in);
}

int32_t half_edge_split_edge(struct half_edge_mesh *he, int32_t h, const float position[3],
                             struct error *err)
{
    if (half_edge_reserve(he, 1, 2, 6, err))
        return -1;
    if (he->half_edges[h].face < 0)
        h = he->half_edges[h].twin;
    int32_t t = he->half_edges[h].twin, v = he->half_edges[t].origin;
    bool is_boundary = he->half_edges[t].face < 0;
    int32_t before = is_boundary ? half_edge_previous(he, t) : -1;
    /* h becomes u -> m and t m -> u; `rest` is m -> v, `back` v -> m */
    int32_t rest = he->half_edge_count, back = rest + 1;
    int32_t middle = add_vertex(he, position, rest);
    he->half_edge_count += is_boundary ? 4 : 6;
    set_half_edge(he, rest, middle, back);
    set_half_edge(he, back, v, rest);
    split_beside(he, h, rest, rest + 2, rest + 3, middle);
    he->half_edges[t].origin = middle;
    if (is_boundary) {
        he->half_edges[before].next = back;
        he->half_edges[back].next = t;
        he->half_edges[back].face = -1;
        return middle;
    }
    if (he->vertex_half_edge[v] == t)
        he->vertex_half_edge[v] = back;
    /* Seen from the other side back = v -> m comes first and t = m -> u is the rest. */
    int32_t second = he->half_edges[t].next, third = he->half_edges[second].next;
    int32_t in = rest + 4, out = rest + 5;
    set_half_edge(he, in, he->half_edges[third].origin, out);
    set_half_edge(he, out, middle, in);
    set_triangle(he, he->half_edges[t].face, t, second, in);
    set_triangle(he, he->face_count++, back, out, third);
    return middle;
}

/* -- flip ----------------------------------------------------------------------------------- */

static bool is_triangle(const struct half_edge_mesh *he, int32_t h)
{
    const struct half_edge *half_edges = he->half_edges;
    return half_edges[h].face >= 0 && half_edges[half_edges[half_edges[h].next].next].next == h;
}

/* The corner opposite h in its triangle. */
static int32_t opposite_corner(const struct half_edge_mesh *he, int32_t h)
{
    return he->half_edges[he->half_edges[he->half_edges[h].next].next].origin;
}

bool half_edge_can_flip(const struct half_edge_mesh *he, int32_t h)
{
    int32_t t = he->half_edges[h].twin;
    if (!is_triangle(he, h) || !is_triangle(he, t))
        return false;
    int32_t w = opposite_corner(he, h), x = opposite_corner(he, t);
    return w != x && half_edge_find(he, w, x) < 0;
}

void half_edge_flip(struct half_edge_mesh *he, int32_t h)
{
    struct half_edge *half_edges = he->half_edges;
    int32_t t = half_edges[h].twin, f = half_edges[h].face, g = half_edges[t].face;
    int32_t h1 = half_edges[h].next, h2 = half_edges[h1].next;
    int32_t t1 = half_edges[t].next, t2 = half_edges[t1].next;
    int32_t u = half_edges[h].origin, v = half_edges[t].origin;
    if (he->vertex_half_edge[u] == h)
        he->vertex_half_edge[u] = t1;
    if (he->vertex_half_edge[v] == t)
        he->vertex_half_edge[v] = h1;
    half_edges[h].origin = half_edges[t2].origin;
    half_edges[t].origin = half_edges[h2].origin;
    set_triangle(he, f, h, h2, t1);
    set_triangle(he, g, t, t2, h1);
}

/* -- collapse ------------------------------------------------------------------------------- */

/* Whether the triangle of h has no neighbour but across h. */
static bool hangs_by(const struct half_edge_mesh *he, int32_t h)
{
    int32_t second = he->half_edges[h].next, third = he->half_edges[second].next;
    return he->half_edges[he->half_edges[second].twin].face < 0 &&
           he->half_edges[he->half_edges[third].twin].face < 0;
}

static bool has_valence_3(const struct half_edge_mesh *he, int32_t vertex)
{
    return half_edge_outgoing(he, vertex, NULL, 0) == 3;
}

bool half_edge_can_collapse(const struct half_edge_mesh *he, int32_t h)
{
    int32_t t = he->half_edges[h].twin;
    int32_t u = he->half_edges[h].origin, v = he->half_edges[t].origin, l = -1, r = -1;
    if (he->half_edges[h].face >= 0) {
        if (!is_triangle(he, h) || hangs_by(he, h))
            return false;
        l = opposite_corner(he, h);
    }
    if (he->half_edges[t].face >= 0) {
        if (!is_triangle(he, t) || hangs_by(he, t))
            return false;
        r = opposite_corner(he, t);
    }
    if (l == r)
        return false;
    if (l >= 0 && r >= 0) {
        if (half_edge_on_boundary(he, u) && half_edge_on_boundary(he, v))
            return false;
        if (has_valence_3(he, u) && has_valence_3(he, v) && !half_edge_on_boundary(he, u) &&
            !half_edge_on_boundary(he, v))
            return false;
    }
    for (int32_t k = half_edge_turn_right(he, h); k != h; k = half_edge_turn_right(he, k)) {
        int32_t w = half_edge_end(he, k);
        if (w != l && w != r && half_edge_find(he, v, w) >= 0)
            return false;
    }
    return true;
}

static void remove_half_edge(struct half_edge_mesh *he, int32_t h)
{
    he->half_edges[h] = (struct half_edge){HALF_EDGE_REMOVED, -1, -1, -1};
}

/* Removes the triangle of h, whose two other sides become one edge. Returns the half edge of that
 * edge that leaves the corner opposite h. */
static int32_t remove_triangle(struct half_edge_mesh *he, int32_t h)
{
    int32_t second = he->half_edges[h].next, third = he->half_edges[second].next;
    int32_t leaving = he->half_edges[second].twin, arriving = he->half_edges[third].twin;
    int32_t corner = he->half_edges[third].origin;
    he->half_edges[leaving].twin = arriving;
    he->half_edges[arriving].twin = leaving;
    if (he->vertex_half_edge[corner] == third)
        he->vertex_half_edge[corner] = leaving;
    he->face_half_edge[he->half_edges[h].face] = HALF_EDGE_REMOVED;
    remove_half_edge(he, second);
    remove_half_edge(he, third);
    return leaving;
}

/* Takes a half edge without a face out of its loop. */
static void unlink_outer(struct half_edge_mesh *he, int32_t h)
{
    he->half_edges[half_edge_previous(he, h)].next = he->half_edges[h].next;
}

/* The half edge that a vertex should keep: the one whose twin has no face, if there is one. */
static int32_t start_of_fan(const struct half_edge_mesh *he, int32_t any)
{
    int32_t h = any;
    do {
        if (he->half_edges[he->half_edges[h].twin].face < 0)
            return h;
        h = half_edge_turn_right(he, h);
    } while (h != any);
    return any;
}

void half_edge_collapse(struct half_edge_mesh *he, int32_t h)
{
    int32_t t = he->half_edges[h].twin;
    int32_t u = he->half_edges[h].origin, v = he->half_edges[t].origin;
    bool was_open = half_edge_on_boundary(he, u) || half_edge_on_boundary(he, v);
    bool has_left = he->half_edges[h].face >= 0, has_right = he->half_edges[t].face >= 0;
    int32_t k = h;
    do {
        he->half_edges[k].origin = v;
        k = half_edge_turn_right(he, k);
    } while (k != h);
    if (!has_left)
        unlink_outer(he, h);
    if (!has_right)
        unlink_outer(he, t);
    int32_t left = has_left ? remove_triangle(he, h) : -1;
    int32_t right = has_right ? remove_triangle(he, t) : -1;
    int32_t any = he->half_edges[has_left ? left : right].twin;
    remove_half_edge(he, h);
    remove_half_edge(he, t);
    he->vertex_half_edge[u] = HALF_EDGE_REMOVED;
    he->vertex_half_edge[v] = was_open ? start_of_fan(he, any) : any;
}

/* -- compaction ----------------------------------------------------------------------------- */

/* New numbers of the entries of a table that are not removed; returns how many. */
static int32_t renumber(const int32_t *table, int64_t stride, int32_t count, int32_t *number)
{
    int32_t kept = 0;
    for (int32_t i = 0; i < count; i++)
        number[i] = table[stride * i] == HALF_EDGE_REMOVED ? -1 : kept++;
    return kept;
}

static int32_t renumbered(const int32_t *number, int32_t old)
{
    return old < 0 ? old : number[old];
}

static void compact(struct half_edge_mesh *he, int32_t *vertex, int32_t *face, int32_t *half_edge)
{
    int32_t vertex_count = renumber(he->vertex_half_edge, 1, he->vertex_count, vertex);
    int32_t face_count = renumber(he->face_half_edge, 1, he->face_count, face);
    int32_t half_edge_count = renumber(&he->half_edges->origin, 4, he->half_edge_count, half_edge);
    for (int32_t h = 0; h < he->half_edge_count; h++) {
        struct half_edge half = he->half_edges[h];
        if (half_edge[h] >= 0)
            he->half_edges[half_edge[h]] =
                (struct half_edge){vertex[half.origin], half_edge[half.twin], half_edge[half.next],
                                   renumbered(face, half.face)};
    }
    for (int32_t v = 0; v < he->vertex_count; v++)
        if (vertex[v] >= 0) {
            he->vertex_half_edge[vertex[v]] = renumbered(half_edge, he->vertex_half_edge[v]);
            memmove(he->positions + 3 * (int64_t)vertex[v], he->positions + 3 * (int64_t)v,
                    3 * sizeof *he->positions);
        }
    for (int32_t f = 0; f < he->face_count; f++)
        if (face[f] >= 0)
            he->face_half_edge[face[f]] = half_edge[he->face_half_edge[f]];
    he->vertex_count = vertex_count;
    he->face_count = face_count;
    he->half_edge_count = half_edge_count;
}

int half_edge_compact(struct half_edge_mesh *he, struct error *err)
{
    int32_t *vertex = malloc((size_t)he->vertex_count * sizeof *vertex + 1);
    int32_t *face = malloc((size_t)he->face_count * sizeof *face + 1);
    int32_t *half_edge = malloc((size_t)he->half_edge_count * sizeof *half_edge + 1);
    bool has_memory = vertex && face && half_edge;
    if (has_memory)
        compact(he, vertex, face, half_edge);
    free(vertex);
    free(face);
    free(half_edge);
    return has_memory
               ? 0
               : error_set(err, "out of memory: compacting %d half edges", he->half_edge_count);
}
