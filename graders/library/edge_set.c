/* The edges of a mesh; see edge_set.h. */
#include "graders/library/edge_set.h"

#include <stdlib.h>

struct side {
    int32_t low, high;
    int32_t triangle;
    bool is_up, is_closing, is_degenerate;
};

/* Sides of all triangles that join two different vertices. Returns how many. */
static int64_t collect_sides(const struct mesh_view *view, struct side *sides)
{
    int64_t count = 0;
    for (int32_t t = 0; t < view->triangle_count; t++) {
        const int32_t *v = view->triangles + 3 * (int64_t)t;
        bool is_degenerate = v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
        for (int corner = 0; corner < 3; corner++) {
            int32_t from = v[corner], to = v[(corner + 1) % 3];
            if (from != to)
                sides[count++] = (struct side){.low = from < to ? from : to,
                                               .high = from < to ? to : from,
                                               .triangle = t,
                                               .is_up = from < to,
                                               .is_closing = corner == 2,
                                               .is_degenerate = is_degenerate};
        }
    }
    return count;
}

static int32_t side_key(const struct side *side, bool by_high)
{
    return by_high ? side->high : side->low;
}

/* Stable counting sort by one end. `start` has room for vertex_count + 1 numbers. */
static void sort_by_end(const struct side *from, struct side *to, int64_t count, bool by_high,
                        int64_t *start, int32_t vertex_count)
{
    for (int64_t v = 0; v <= vertex_count; v++)
        start[v] = 0;
    for (int64_t i = 0; i < count; i++)
        start[side_key(&from[i], by_high) + 1]++;
    for (int64_t v = 0; v < vertex_count; v++)
        start[v + 1] += start[v];
    for (int64_t i = 0; i < count; i++)
        to[start[side_key(&from[i], by_high)]++] = from[i];
}

static struct listed_edge edge_of_side(const struct side *side)
{
    return (struct listed_edge){.low = side->low,
                                .high = side->high,
                                .triangle = side->triangle,
                                .flags = EDGE_CLOSING_ONLY | EDGE_DEGENERATE_ONLY,
                                .first_entry = -1};
}

/* Equal sides stand together; each group becomes an edge. */
static void merge_sides(const struct side *sides, int64_t count, struct edge_set *set)
{
    for (int64_t i = 0; i < count; i++) {
        const struct side *side = &sides[i];
        if (i == 0 || side->low != sides[i - 1].low || side->high != sides[i - 1].high)
            set->edges[set->count++] = edge_of_side(side);
        struct listed_edge *edge = &set->edges[set->count - 1];
        edge->side_count++;
        edge->flags |= side->is_up ? EDGE_UP : EDGE_DOWN;
        if (!side->is_closing)
            edge->flags &= ~(uint32_t)EDGE_CLOSING_ONLY;
        if (!side->is_degenerate)
            edge->flags &= ~(uint32_t)EDGE_DEGENERATE_ONLY;
    }
}

static void index_rows(struct edge_set *set, int32_t vertex_count)
{
    int64_t e = 0;
    for (int64_t v = 0; v <= vertex_count; v++) {
        while (e < set->count && set->edges[e].low < v)
            e++;
        set->row[v] = e;
    }
}

int edge_set_make(const struct mesh_view *view, struct edge_set *set, struct error *err)
{
    size_t side_room = 3 * (size_t)view->triangle_count + 1;
    struct side *sides = calloc(side_room, sizeof *sides);
    struct side *sorted = calloc(side_room, sizeof *sorted);
    *set = (struct edge_set){.edges = calloc(side_room, sizeof *set->edges),
                             .row = calloc((size_t)view->vertex_count + 2, sizeof *set->row)};
    bool has_memory = sides && sorted && set->edges && set->row;
    if (has_memory) {
        int64_t count = collect_sides(view, sides);
        sort_by_end(sides, sorted, count, true, set->row, view->vertex_count);
        sort_by_end(sorted, sides, count, false, set->row, view->vertex_count);
        merge_sides(sides, count, set);
        index_rows(set, view->vertex_count);
    } else {
        edge_set_release(set);
    }
    free(sides);
    free(sorted);
    return has_memory
               ? 0
               : error_set(err, "out of memory: the edges of %d triangles", view->triangle_count);
}

void edge_set_release(struct edge_set *set)
{
    free(set->edges);
    free(set->row);
    *set = (struct edge_set){0};
}

struct listed_edge *edge_set_find(const struct edge_set *set, int32_t a, int32_t b)
{
    int32_t low = a < b ? a : b, high = a < b ? b : a;
    int64_t first = set->row[low], last = set->row[low + 1];
    while (first < last) {
        int64_t middle = first + (last - first) / 2;
        if (set->edges[middle].high < high)
            first = middle + 1;
        else
            last = middle;
    }
    if (first < set->row[low + 1] && set->edges[first].high == high)
        return &set->edges[first];
    return NULL;
}
