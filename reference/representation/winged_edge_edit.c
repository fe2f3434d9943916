/* Edits of winged edges, each a rewiring of a few rows; see winged_edge_edit.h for the pictures. */
#include "reference/representation/winged_edge_edit.h"

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

static bool grow_vertices(struct winged_edge_mesh *we, int64_t wanted)
{
    void *positions = we->positions, *links = we->vertex_edge;
    int32_t positions_capacity = we->vertex_capacity, links_capacity = we->vertex_capacity;
    bool done = grow(&positions, &positions_capacity, wanted, 3 * sizeof *we->positions) &&
                grow(&links, &links_capacity, wanted, sizeof *we->vertex_edge);
    we->positions = positions;
    we->vertex_edge = links;
    if (done)
        we->vertex_capacity = links_capacity;
    return done;
}

int winged_edge_reserve(struct winged_edge_mesh *we, int64_t more_vertices, int64_t more_faces,
                        int64_t more_edges, struct error *err)
{
    int64_t vertices = we->vertex_count + more_vertices, faces = we->face_count + more_faces;
    int64_t edges = we->edge_count + more_edges;
    if (vertices > INT32_MAX || faces > INT32_MAX || edges > INT32_MAX)
        return error_set(err, "%lld edges are more than an int32 can number", (long long)edges);
    void *rows = we->edges, *links = we->face_edge;
    bool done = grow(&rows, &we->edge_capacity, edges, sizeof *we->edges) &&
                grow(&links, &we->face_capacity, faces, sizeof *we->face_edge) &&
                grow_vertices(we, vertices);
    we->edges = rows;
    we->face_edge = links;
    return done ? 0 : error_set(err, "out of memory: %lld edges", (long long)edges);
}

/* -- rewiring ------------------------------------------------------------------------------- */

static struct winged_side side_of(int32_t edge, int32_t way)
{
    return (struct winged_side){edge, way};
}

/* The side before this one in its face or along its hole. */
static struct winged_side previous_side(const struct winged_edge_mesh *we, struct winged_side side)
{
    return winged_edge_twin(winged_edge_turn_left(we, side));
}

/* Makes b the side after a. */
static void link_sides(struct winged_edge_mesh *we, struct winged_side a, struct winged_side b)
{
    we->edges[a.edge].next[a.way] = b.edge;
    we->edges[b.edge].previous[b.way] = a.edge;
}

static void set_triangle(struct winged_edge_mesh *we, int32_t face, struct winged_side a,
                         struct winged_side b, struct winged_side c)
{
    link_sides(we, a, b);
    link_sides(we, b, c);
    link_sides(we, c, a);
    we->edges[a.edge].face[a.way] = face;
    we->edges[b.edge].face[b.way] = face;
    we->edges[c.edge].face[c.way] = face;
    we->face_edge[face] = a.edge;
}

static int32_t add_vertex(struct winged_edge_mesh *we, const float position[3], int32_t edge)
{
    int32_t vertex = we->vertex_count++;
    memcpy(we->positions + 3 * (int64_t)vertex, position, 3 * sizeof *position);
    we->vertex_edge[vertex] = edge;
    return vertex;
}

/* An edge without faces and neighbours yet. */
static int32_t add_edge(struct winged_edge_mesh *we, int32_t from, int32_t to)
{
    we->edges[we->edge_count] = (struct winged_edge){{from, to}, {-1, -1}, {-1, -1}, {-1, -1}};
    return we->edge_count++;
}

/* -- splits --------------------------------------------------------------------------------- */

int32_t winged_edge_split_face(struct winged_edge_mesh *we, int32_t face, const float position[3],
                               struct error *err)
{
    if (winged_edge_reserve(we, 1, 2, 3, err))
        return -1;
    struct winged_side sides[3] = {winged_edge_of_face(we, face)};
    sides[1] = winged_edge_next(we, sides[0]);
    sides[2] = winged_edge_next(we, sides[1]);
    int32_t first = we->edge_count, middle = add_vertex(we, position, first);
    for (int i = 0; i < 3; i++)
        add_edge(we, winged_edge_start(we, sides[i]), middle);
    we->face_count += 2;
    for (int i = 0; i < 3; i++)
        set_triangle(we, i == 0 ? face : we->face_count - 3 + i, sides[i],
                     side_of(first + (i + 1) % 3, 0), side_of(first + i, 1));
    return middle;
}

/* Cuts the triangle of `side`, whose edge now ends at the middle, where `rest` goes on. `is_before`
 * tells which comes first: side and then rest, or the other way round. */
static void split_beside(struct winged_edge_mesh *we, struct winged_side side,
                         struct winged_side rest, bool is_before, struct winged_side second,
                         struct winged_side third, int32_t middle)
{
    int32_t spoke = add_edge(we, winged_edge_start(we, third), middle);
    struct winged_side in = side_of(spoke, 0), out = side_of(spoke, 1);
    int32_t face = winged_edge_face(we, side), new_face = we->face_count++;
    if (is_before) {
        set_triangle(we, face, side, out, third);
        set_triangle(we, new_face, rest, second, in);
    } else {
        set_triangle(we, face, side, second, in);
        set_triangle(we, new_face, rest, out, third);
    }
}

int32_t winged_edge_split_edge(struct winged_edge_mesh *we, struct winged_side h,
                               const float position[3], struct error *err)
{
    if (winged_edge_reserve(we, 1, 2, 3, err))
        return -1;
    if (winged_edge_face(we, h) < 0)
        h = winged_edge_twin(h);
    struct winged_side t = winged_edge_twin(h), h1 = winged_edge_next(we, h);
    struct winged_side h2 = winged_edge_next(we, h1), t1 = winged_edge_next(we, t);
    struct winged_side before_t = previous_side(we, t);
    int32_t v = winged_edge_end(we, h);
    /* h becomes u -> m and t m -> u; `rest` is m -> v, `back` v -> m */
    int32_t middle = add_vertex(we, position, we->edge_count);
    struct winged_side rest = side_of(add_edge(we, middle, v), 0), back = winged_edge_twin(rest);
    we->edges[h.edge].vertex[1 - h.way] = middle;
    split_beside(we, h, rest, true, h1, h2, middle);
    if (winged_edge_face(we, t) < 0) {
        link_sides(we, before_t, back);
        link_sides(we, back, t);
        return middle;
    }
    if (we->vertex_edge[v] == h.edge)
        we->vertex_edge[v] = rest.edge;
    split_beside(we, t, back, false, t1, before_t, middle);
    return middle;
}

/* -- flip ----------------------------------------------------------------------------------- */

static bool is_triangle(const struct winged_edge_mesh *we, struct winged_side side)
{
    struct winged_side third = winged_edge_next(we, winged_edge_next(we, side));
    return winged_edge_face(we, side) >= 0 && winged_edge_next(we, third).edge == side.edge;
}

/* The corner opposite a side in its triangle. */
static int32_t opposite_corner(const struct winged_edge_mesh *we, struct winged_side side)
{
    return winged_edge_end(we, winged_edge_next(we, side));
}

bool winged_edge_can_flip(const struct winged_edge_mesh *we, struct winged_side h)
{
    struct winged_side t = winged_edge_twin(h);
    if (!is_triangle(we, h) || !is_triangle(we, t))
        return false;
    int32_t w = opposite_corner(we, h), x = opposite_corner(we, t);
    return w != x && winged_edge_find(we, w, x) < 0;
}

void winged_edge_flip(struct winged_edge_mesh *we, struct winged_side h)
{
    struct winged_side t = winged_edge_twin(h);
    struct winged_side h1 = winged_edge_next(we, h), h2 = winged_edge_next(we, h1);
    struct winged_side t1 = winged_edge_next(we, t), t2 = winged_edge_next(we, t1);
    int32_t u = winged_edge_start(we, h), v = winged_edge_end(we, h);
    int32_t w = winged_edge_start(we, h2), x = winged_edge_start(we, t2);
    if (we->vertex_edge[u] == h.edge)
        we->vertex_edge[u] = t1.edge;
    if (we->vertex_edge[v] == h.edge)
        we->vertex_edge[v] = h1.edge;
    we->edges[h.edge].vertex[h.way] = x;
    we->edges[h.edge].vertex[t.way] = w;
    set_triangle(we, winged_edge_face(we, h), h, h2, t1);
    set_triangle(we, winged_edge_face(we, t), t, t2, h1);
}

/* -- collapse ------------------------------------------------------------------------------- */

/* Whether the triangle of a side has no neighbour but across it. */
static bool hangs_by(const struct winged_edge_mesh *we, struct winged_side side)
{
    struct winged_side second = winged_edge_next(we, side), third = winged_edge_next(we, second);
    return winged_edge_face(we, winged_edge_twin(second)) < 0 &&
           winged_edge_face(we, winged_edge_twin(third)) < 0;
}

static bool has_valence_3(const struct winged_edge_mesh *we, int32_t vertex)
{
    struct winged_side first = winged_edge_of_vertex(we, vertex), side = first;
    for (int i = 0; i < 3; i++) {
        side = winged_edge_turn_left(we, side);
        if (side.edge == first.edge)
            return i == 2;
    }
    return false;
}

/* Whether the corners opposite the two triangles of a side allow its collapse. */
static bool corners_allow(const struct winged_edge_mesh *we, int32_t u, int32_t v, int32_t l,
                          int32_t r)
{
    if (l == r)
        return false;
    if (l < 0 || r < 0)
        return true;
    bool u_is_open = winged_edge_on_boundary(we, u), v_is_open = winged_edge_on_boundary(we, v);
    if (u_is_open && v_is_open)
        return false;
    return u_is_open || v_is_open || !has_valence_3(we, u) || !has_valence_3(we, v);
}

bool winged_edge_can_collapse(const struct winged_edge_mesh *we, struct winged_side h)
{
    struct winged_side sides[2] = {h, winged_edge_twin(h)};
    int32_t u = winged_edge_start(we, h), v = winged_edge_end(we, h), corner[2] = {-1, -1};
    for (int i = 0; i < 2; i++) {
        if (winged_edge_face(we, sides[i]) < 0)
            continue;
        if (!is_triangle(we, sides[i]) || hangs_by(we, sides[i]))
            return false;
        corner[i] = opposite_corner(we, sides[i]);
    }
    if (!corners_allow(we, u, v, corner[0], corner[1]))
        return false;
    for (struct winged_side k = winged_edge_turn_left(we, h); k.edge != h.edge;
         k = winged_edge_turn_left(we, k)) {
        int32_t w = winged_edge_end(we, k);
        if (w != corner[0] && w != corner[1] && winged_edge_find(we, v, w) >= 0)
            return false;
    }
    return true;
}

static void remove_edge(struct winged_edge_mesh *we, int32_t edge)
{
    we->edges[edge] = (struct winged_edge){{WINGED_EDGE_REMOVED, -1}, {-1, -1}, {-1, -1}, {-1, -1}};
}

/* Removes a triangle with two sides that have become parallel: `keep` takes over what lies beyond
 * `drop`, at whose far corner both meet. */
static void remove_triangle(struct winged_edge_mesh *we, struct winged_side keep,
                            struct winged_side drop, int32_t corner)
{
    struct winged_side beyond = winged_edge_twin(drop);
    struct winged_side next = winged_edge_next(we, beyond), before = previous_side(we, beyond);
    int32_t face = winged_edge_face(we, beyond);
    we->face_edge[winged_edge_face(we, keep)] = WINGED_EDGE_REMOVED;
    we->edges[keep.edge].face[keep.way] = face;
    link_sides(we, keep, next);
    link_sides(we, before, keep);
    if (face >= 0 && we->face_edge[face] == drop.edge)
        we->face_edge[face] = keep.edge;
    if (we->vertex_edge[corner] == drop.edge)
        we->vertex_edge[corner] = keep.edge;
    remove_edge(we, drop.edge);
}

/* The edge that a vertex should keep: the one without a face to its right, if there is one. */
static int32_t start_of_fan(const struct winged_edge_mesh *we, int32_t any, int32_t vertex)
{
    struct winged_side first = winged_edge_leaving(we, any, vertex), side = first;
    do {
        if (winged_edge_face(we, winged_edge_twin(side)) < 0)
            return side.edge;
        side = winged_edge_turn_left(we, side);
    } while (side.edge != first.edge);
    return any;
}

/* Makes the edges of u edges of v. */
static void move_edges(struct winged_edge_mesh *we, struct winged_side first, int32_t v)
{
    struct winged_side side = first;
    do {
        struct winged_side left = winged_edge_turn_left(we, side);
        we->edges[side.edge].vertex[side.way] = v;
        side = left;
    } while (side.edge != first.edge);
}

void winged_edge_collapse(struct winged_edge_mesh *we, struct winged_side h)
{
    struct winged_side t = winged_edge_twin(h);
    struct winged_side h1 = winged_edge_next(we, h), h2 = previous_side(we, h);
    struct winged_side t1 = winged_edge_next(we, t), t2 = previous_side(we, t);
    int32_t u = winged_edge_start(we, h), v = winged_edge_end(we, h);
    int32_t l = winged_edge_end(we, h1), r = winged_edge_end(we, t1);
    bool was_open = winged_edge_on_boundary(we, u) || winged_edge_on_boundary(we, v);
    bool has_left = winged_edge_face(we, h) >= 0, has_right = winged_edge_face(we, t) >= 0;
    move_edges(we, h, v);
    /* Holes first: while the edge is in one, its two ends cannot be told apart. */
    if (!has_left)
        link_sides(we, h2, h1);
    if (!has_right)
        link_sides(we, t2, t1);
    if (has_left)
        remove_triangle(we, h1, h2, l);
    if (has_right)
        remove_triangle(we, t2, t1, r);
    remove_edge(we, h.edge);
    we->vertex_edge[u] = WINGED_EDGE_REMOVED;
    int32_t any = has_left ? h1.edge : t2.edge;
    we->vertex_edge[v] = was_open ? start_of_fan(we, any, v) : any;
}

/* -- compaction ----------------------------------------------------------------------------- */

/* New numbers of the entries of a table that are not removed; returns how many. */
static int32_t renumber(const int32_t *table, int64_t stride, int32_t count, int32_t *number)
{
    int32_t kept = 0;
    for (int32_t i = 0; i < count; i++)
        number[i] = table[stride * i] == WINGED_EDGE_REMOVED ? -1 : kept++;
    return kept;
}

static int32_t renumbered(const int32_t *number, int32_t old)
{
    return old < 0 ? old : number[old];
}

static struct winged_edge renumbered_edge(struct winged_edge edge, const int32_t *vertex,
                                          const int32_t *face, const int32_t *number)
{
    for (int way = 0; way < 2; way++) {
        edge.vertex[way] = vertex[edge.vertex[way]];
        edge.face[way] = renumbered(face, edge.face[way]);
        edge.previous[way] = number[edge.previous[way]];
        edge.next[way] = number[edge.next[way]];
    }
    return edge;
}

static void compact(struct winged_edge_mesh *we, int32_t *vertex, int32_t *face, int32_t *edge)
{
    int32_t vertex_count = renumber(we->vertex_edge, 1, we->vertex_count, vertex);
    int32_t face_count = renumber(we->face_edge, 1, we->face_count, face);
    int32_t edge_count = renumber(we->edges->vertex, 8, we->edge_count, edge);
    for (int32_t e = 0; e < we->edge_count; e++)
        if (edge[e] >= 0)
            we->edges[edge[e]] = renumbered_edge(we->edges[e], vertex, face, edge);
    for (int32_t v = 0; v < we->vertex_count; v++)
        if (vertex[v] >= 0) {
            we->vertex_edge[vertex[v]] = renumbered(edge, we->vertex_edge[v]);
            memmove(we->positions + 3 * (int64_t)vertex[v], we->positions + 3 * (int64_t)v,
                    3 * sizeof *we->positions);
        }
    for (int32_t f = 0; f < we->face_count; f++)
        if (face[f] >= 0)
            we->face_edge[face[f]] = edge[we->face_edge[f]];
    we->vertex_count = vertex_count;
    we->face_count = face_count;
    we->edge_count = edge_count;
}

int winged_edge_compact(struct winged_edge_mesh *we, struct error *err)
{
    int32_t *vertex = malloc((size_t)we->vertex_count * sizeof *vertex + 1);
    int32_t *face = malloc((size_t)we->face_count * sizeof *face + 1);
    int32_t *edge = malloc((size_t)we->edge_count * sizeof *edge + 1);
    bool has_memory = vertex && face && edge;
    if (has_memory)
        compact(we, vertex, face, edge);
    free(vertex);
    free(face);
    free(edge);
    return has_memory ? 0 : error_set(err, "out of memory: compacting %d edges", we->edge_count);
}
