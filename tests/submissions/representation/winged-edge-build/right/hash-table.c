/* A hash table of directed sides: each looks for the one that runs the other way. */
#include "winged-edge-build.h"

#include <stdbool.h>
#include <stdlib.h>

struct table {
    uint64_t *keys; /* from << 32 | to, plus 1; 0: free */
    int32_t *side;
    size_t mask;
};

static size_t place(const struct table *table, int32_t from, int32_t to)
{
    uint64_t key = ((uint64_t)from << 32 | (uint64_t)to) + 1;
    uint64_t hash = key * 0x9E3779B97F4A7C15u;
    size_t i = (size_t)(hash ^ hash >> 32) & table->mask;
    while (table->keys[i] != 0 && table->keys[i] != key)
        i = (i + 1) & table->mask;
    return i;
}

struct work {
    const int32_t *first_corner, *corners;
    int32_t face_count, corner_count;
    int32_t *next, *previous, *face, *edge; /* of each side */
    struct table table;
};

static void release(struct work *w)
{
    free(w->next);
    free(w->previous);
    free(w->face);
    free(w->edge);
    free(w->table.keys);
    free(w->table.side);
}

static bool allocate(struct work *w)
{
    size_t n = (size_t)w->corner_count, slots = 4;
    while (slots < 2 * n)
        slots *= 2;
    w->table.mask = slots - 1;
    w->next = malloc(n * 4 + 1);
    w->previous = malloc(n * 4 + 1);
    w->face = malloc(n * 4 + 1);
    w->edge = malloc(n * 4 + 1);
    w->table.keys = calloc(slots, sizeof *w->table.keys);
    w->table.side = malloc(slots * sizeof *w->table.side);
    return w->next && w->previous && w->face && w->edge && w->table.keys && w->table.side;
}

/* Finds next and previous, and puts every side into the table. Returns whether two run the same
 * way. */
static bool enter_sides(struct work *w)
{
    bool repeated = false;
    for (int32_t f = 0; f < w->face_count; f++)
        for (int32_t s = w->first_corner[f]; s < w->first_corner[f + 1]; s++) {
            w->face[s] = f;
            w->next[s] = s + 1 < w->first_corner[f + 1] ? s + 1 : w->first_corner[f];
            w->previous[w->next[s]] = s;
        }
    for (int32_t s = 0; s < w->corner_count; s++) {
        int32_t from = w->corners[s], to = w->corners[w->next[s]];
        size_t i = place(&w->table, from, to);
        repeated = repeated || w->table.keys[i] != 0;
        w->table.keys[i] = ((uint64_t)from << 32 | (uint64_t)to) + 1;
        w->table.side[i] = s;
    }
    return repeated;
}

static int32_t twin(const struct work *w, int32_t s)
{
    size_t i = place(&w->table, w->corners[w->next[s]], w->corners[s]);
    return w->table.keys[i] != 0 ? w->table.side[i] : NONE;
}

/* Two sides run the same way: is there an edge of three? Sides that are alike are counted in a
 * second round, which only such meshes need. */
static int32_t why_repeated(struct work *w)
{
    for (size_t i = 0; i <= w->table.mask; i++)
        w->table.side[i] = 0;
    for (int32_t s = 0; s < w->corner_count; s++) {
        int32_t a = w->corners[s], b = w->corners[w->next[s]];
        size_t i = place(&w->table, a < b ? a : b, a < b ? b : a);
        if (w->table.keys[i] == 0)
            i = place(&w->table, a < b ? b : a, a < b ? a : b);
        if (++w->table.side[i] > 2)
            return NOT_MANIFOLD;
    }
    return NOT_ORIENTABLE;
}

static int32_t number_edges(struct work *w)
{
    int32_t count = 0;
    for (int32_t s = 0; s < w->corner_count; s++) {
        int32_t t = twin(w, s);
        w->edge[s] = t != NONE && t < s ? w->edge[t] : count++;
    }
    return count;
}

static void fill(const struct work *w, struct winged_edge *edges, int32_t *vertex_edge,
                 int32_t vertex_count, int32_t *face_edge)
{
    for (int32_t v = 0; v < vertex_count; v++)
        vertex_edge[v] = NONE;
    for (int32_t s = 0; s < w->corner_count; s++) {
        struct winged_edge *e = &edges[w->edge[s]];
        int32_t t = twin(w, s);
        face_edge[w->face[s]] = w->edge[s];
        vertex_edge[w->corners[s]] = vertex_edge[w->corners[w->next[s]]] = w->edge[s];
        if (t != NONE && t < s)
            continue;
        *e =
            (struct winged_edge){w->corners[s],           w->corners[w->next[s]], w->face[s], NONE,
                                 w->edge[w->previous[s]], w->edge[w->next[s]],    NONE,       NONE};
        if (t != NONE) {
            e->ci = w->face[t];
            e->aia = w->edge[w->previous[t]];
            e->ais = w->edge[w->next[t]];
        }
    }
}

/* Sides that leave a vertex hang together by turning; each fan is walked once, from its boundary if
 * it has one. A vertex that is met by two walks has two fans. */
static bool has_two_fans(const struct work *w, int32_t *walked, int32_t vertex_count)
{
    int64_t left = w->corner_count;
    for (int32_t v = 0; v < vertex_count; v++)
        walked[v] = NONE;
    for (int32_t s = 0; s < w->corner_count; s++) /* any side, or one on a boundary */
        if (walked[w->corners[s]] == NONE || twin(w, s) == NONE)
            walked[w->corners[s]] = s;
    for (int32_t v = 0; v < vertex_count; v++)
        for (int32_t s = walked[v]; s != NONE; left--) {
            s = twin(w, w->previous[s]);
            if (s == walked[v])
                s = NONE;
        }
    return left != 0;
}

int32_t winged_edge_build(const int32_t *first_corner, const int32_t *corners, int32_t face_count,
                          int32_t vertex_count, struct winged_edge **edges, int32_t *vertex_edge,
                          int32_t *face_edge)
{
    struct work w = {first_corner, corners, face_count, 0, NULL, NULL, NULL, NULL, {NULL, NULL, 0}};
    w.corner_count = face_count > 0 ? first_corner[face_count] : 0;
    int32_t result = OUT_OF_MEMORY;
    *edges = NULL;
    if (allocate(&w)) {
        if (enter_sides(&w))
            result = why_repeated(&w);
        else if (has_two_fans(&w, vertex_edge, vertex_count))
            result = NOT_MANIFOLD;
        else {
            int32_t count = number_edges(&w);
            *edges = malloc((size_t)count * sizeof **edges + 1);
            if (*edges) {
                fill(&w, *edges, vertex_edge, vertex_count, face_edge);
                result = count;
            }
        }
    }
    release(&w);
    return result;
}
