/* Lists the corners of each vertex: a side finds the one that runs the other way among the sides
 * that leave its end, and going round a vertex ends where its list ends. */
#include "winged-edge-build.h"

#include <stdlib.h>

struct corner {
    int32_t vertex, face, next, previous; /* previous and next corner of its face */
    int32_t twin, edge;
};

struct mesh {
    struct corner *corners;
    int32_t *start; /* of each vertex: its corners are at[start[v]] ... at[start[v + 1] - 1] */
    int32_t *at;
    int32_t corner_count, vertex_count;
};

static void read_faces(struct mesh *m, const int32_t *first_corner, const int32_t *vertices,
                       int32_t face_count)
{
    for (int32_t f = 0; f < face_count; f++)
        for (int32_t c = first_corner[f], end = first_corner[f + 1]; c < end; c++) {
            m->corners[c].vertex = vertices[c];
            m->corners[c].face = f;
            m->corners[c].next = c + 1 < end ? c + 1 : first_corner[f];
            m->corners[m->corners[c].next].previous = c;
        }
    for (int32_t v = 0; v <= m->vertex_count; v++)
        m->start[v] = 0;
    for (int32_t c = 0; c < m->corner_count; c++)
        m->start[vertices[c]]++;
    for (int32_t v = 0; v < m->vertex_count; v++)
        m->start[v + 1] += m->start[v];
    for (int32_t c = 0; c < m->corner_count; c++)
        m->at[--m->start[vertices[c]]] = c;
}

static int32_t end_of(const struct mesh *m, int32_t c)
{
    return m->corners[m->corners[c].next].vertex;
}

/* Counts the sides from one vertex to another, and tells one of them. */
static int32_t count_sides(const struct mesh *m, int32_t from, int32_t to, int32_t *side)
{
    int32_t count = 0;
    for (int32_t i = m->start[from]; i < m->start[from + 1]; i++)
        if (end_of(m, m->at[i]) == to) {
            *side = m->at[i];
            count++;
        }
    return count;
}

/* Returns the number of edges, or why not. */
static int32_t pair_sides(struct mesh *m)
{
    int32_t refusal = 0, edge_count = 0;
    for (int32_t c = 0; c < m->corner_count; c++) {
        int32_t from = m->corners[c].vertex, to = end_of(m, c), other = NONE, same = NONE;
        int32_t backwards = count_sides(m, to, from, &other);
        int32_t forwards = count_sides(m, from, to, &same);
        if (backwards + forwards > 2)
            return NOT_MANIFOLD;
        if (forwards > 1)
            refusal = NOT_ORIENTABLE;
        m->corners[c].twin = other;
        m->corners[c].edge = other != NONE && other < c ? m->corners[other].edge : edge_count++;
    }
    return refusal ? refusal : edge_count;
}

/* Goes from face to face round a vertex, both ways from its first corner. */
static int32_t fan_length(const struct mesh *m, int32_t v)
{
    int32_t first = m->at[m->start[v]], length = 0, c = first;
    do {
        length++;
        c = m->corners[m->corners[c].previous].twin;
    } while (c != NONE && c != first);
    if (c == first)
        return length;
    for (c = m->corners[first].twin; c != NONE; c = m->corners[m->corners[c].next].twin)
        length++;
    return length;
}

static void fill(const struct mesh *m, struct winged_edge *edges, int32_t *face_edge)
{
    for (int32_t c = 0; c < m->corner_count; c++) {
        const struct corner *corner = &m->corners[c];
        struct winged_edge *edge = &edges[corner->edge];
        int32_t before = m->corners[corner->previous].edge, after = m->corners[corner->next].edge;
        face_edge[corner->face] = corner->edge;
        if (corner->twin == NONE || c < corner->twin) {
            edge->vf = corner->vertex; /* the second half of the faces' way: ci */
            edge->vi = end_of(m, c);
            edge->ci = corner->face;
            edge->aia = before;
            edge->ais = after;
        } else {
            edge->cd = corner->face;
            edge->ada = before;
            edge->ads = after;
        }
        if (corner->twin == NONE)
            edge->cd = edge->ada = edge->ads = NONE;
    }
}

static int32_t build(struct mesh *m, struct winged_edge **edges, int32_t *vertex_edge,
                     int32_t *face_edge)
{
    int32_t count = pair_sides(m);
    for (int32_t v = 0; count >= 0 && v < m->vertex_count; v++) {
        int32_t degree = m->start[v + 1] - m->start[v];
        vertex_edge[v] = degree > 0 ? m->corners[m->at[m->start[v]]].edge : NONE;
        if (degree > 0 && fan_length(m, v) != degree)
            return NOT_MANIFOLD;
    }
    if (count < 0)
        return count;
    *edges = malloc((size_t)count * sizeof **edges + 1);
    if (!*edges)
        return OUT_OF_MEMORY;
    fill(m, *edges, face_edge);
    return count;
}

int32_t winged_edge_build(const int32_t *first_corner, const int32_t *corners, int32_t face_count,
                          int32_t vertex_count, struct winged_edge **edges, int32_t *vertex_edge,
                          int32_t *face_edge)
{
    struct mesh m = {NULL, NULL, NULL, face_count > 0 ? first_corner[face_count] : 0, vertex_count};
    m.corners = malloc((size_t)m.corner_count * sizeof *m.corners + 1);
    m.start = malloc(((size_t)vertex_count + 1) * sizeof *m.start);
    m.at = malloc((size_t)m.corner_count * sizeof *m.at + 1);
    int32_t result = OUT_OF_MEMORY;
    *edges = NULL;
    if (m.corners && m.start && m.at) {
        read_faces(&m, first_corner, corners, face_count);
        result = build(&m, edges, vertex_edge, face_edge);
    }
    free(m.corners);
    free(m.start);
    free(m.at);
    return result;
}
