/* Sorts the sides by their two vertices: equal ones are neighbours and make an edge, which runs
 * from its lower to its higher vertex. Fans are joined edge by edge, by union and find. */
#include "winged-edge-build.h"

#include <stdbool.h>
#include <stdlib.h>

struct side {
    int32_t low, high, corner;
    int32_t is_down; /* runs from high to low */
};

static int compare(const void *p, const void *q)
{
    const struct side *a = p, *b = q;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return a->is_down - b->is_down;
}

static bool is_same_edge(const struct side *a, const struct side *b)
{
    return a->low == b->low && a->high == b->high;
}

/* Faces at a vertex are corners; those that share an edge at the vertex are joined. */
static int32_t find(int32_t *parent, int32_t c)
{
    while (parent[c] != c) {
        parent[c] = parent[parent[c]];
        c = parent[c];
    }
    return c;
}

/* Makes the sides. next[c] is the corner after c, face[c] its face. */
static void make_sides(const int32_t *first_corner, const int32_t *corners, int32_t face_count,
                       struct side *sides, int32_t *next, int32_t *face)
{
    for (int32_t f = 0; f < face_count; f++)
        for (int32_t c = first_corner[f]; c < first_corner[f + 1]; c++) {
            next[c] = c + 1 < first_corner[f + 1] ? c + 1 : first_corner[f];
            face[c] = f;
            int32_t a = corners[c], b = corners[next[c]];
            sides[c] = (struct side){a < b ? a : b, a < b ? b : a, c, a > b};
        }
}

/* Returns the number of edges, or why not. */
static int32_t count_edges(const struct side *sides, int32_t count)
{
    int32_t edges = 0, refusal = 0;
    for (int32_t i = 0; i < count; i++) {
        if (i == 0 || !is_same_edge(&sides[i], &sides[i - 1]))
            edges++;
        else if (i >= 2 && is_same_edge(&sides[i], &sides[i - 2]))
            return NOT_MANIFOLD;
        else if (sides[i].is_down == sides[i - 1].is_down)
            refusal = NOT_ORIENTABLE;
    }
    return refusal ? refusal : edges;
}

/* Every vertex has as many corners as joins, or one more. */
static bool has_two_fans(const struct side *sides, const int32_t *corners, const int32_t *next,
                         int32_t count, int32_t *parent, int32_t *group, int32_t vertex_count)
{
    for (int32_t c = 0; c < count; c++)
        parent[c] = c;
    for (int32_t i = 1; i < count; i++)
        if (is_same_edge(&sides[i], &sides[i - 1])) {
            int32_t c = sides[i - 1].corner, d = sides[i].corner;
            parent[find(parent, c)] = find(parent, next[d]);
            parent[find(parent, next[c])] = find(parent, d);
        }
    for (int32_t v = 0; v < vertex_count; v++)
        group[v] = NONE;
    for (int32_t c = 0; c < count; c++) {
        int32_t mine = find(parent, c);
        if (group[corners[c]] != NONE && group[corners[c]] != mine)
            return true;
        group[corners[c]] = mine;
    }
    return false;
}

static void fill(const struct side *sides, int32_t count, const int32_t *next, const int32_t *face,
                 int32_t *edge, struct winged_edge *edges, int32_t *vertex_edge, int32_t *face_edge)
{
    int32_t e = -1;
    for (int32_t i = 0; i < count; i++) {
        if (i == 0 || !is_same_edge(&sides[i], &sides[i - 1])) {
            edges[++e] = (struct winged_edge){sides[i].low, sides[i].high, NONE, NONE,
                                              NONE,         NONE,          NONE, NONE};
            vertex_edge[sides[i].low] = vertex_edge[sides[i].high] = e;
        }
        edge[sides[i].corner] = e;
        *(sides[i].is_down ? &edges[e].ci : &edges[e].cd) = face[sides[i].corner];
        face_edge[face[sides[i].corner]] = e;
    }
    for (int32_t c = 0; c < count; c++) {
        struct winged_edge *one = &edges[edge[c]], *other = &edges[edge[next[c]]];
        *(one->cd == face[c] ? &one->ads : &one->ais) = edge[next[c]];
        *(other->cd == face[c] ? &other->ada : &other->aia) = edge[c];
    }
}

int32_t winged_edge_build(const int32_t *first_corner, const int32_t *corners, int32_t face_count,
                          int32_t vertex_count, struct winged_edge **edges, int32_t *vertex_edge,
                          int32_t *face_edge)
{
    int32_t count = face_count > 0 ? first_corner[face_count] : 0, result = OUT_OF_MEMORY;
    size_t bytes = (size_t)count * sizeof(int32_t) + 1;
    struct side *sides = malloc((size_t)count * sizeof *sides + 1);
    int32_t *next = malloc(bytes), *face = malloc(bytes), *spare = malloc(bytes);
    *edges = NULL;
    if (sides && next && face && spare) {
        make_sides(first_corner, corners, face_count, sides, next, face);
        if (count > 0)
            qsort(sides, (size_t)count, sizeof *sides, compare);
        result = count_edges(sides, count);
        if (result >= 0 &&
            has_two_fans(sides, corners, next, count, spare, vertex_edge, vertex_count))
            result = NOT_MANIFOLD;
        if (result >= 0) {
            *edges = malloc((size_t)result * sizeof **edges + 1);
            if (!*edges)
                result = OUT_OF_MEMORY;
        }
        if (result >= 0) {
            for (int32_t v = 0; v < vertex_count; v++)
                vertex_edge[v] = NONE;
            fill(sides, count, next, face, spare, *edges, vertex_edge, face_edge);
        }
    }
    free(sides);
    free(next);
    free(face);
    free(spare);
    return result;
}
