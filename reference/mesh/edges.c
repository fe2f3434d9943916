/* The edge list by counting sort; see edges.h. */
#include "reference/mesh/edges.h"

#include <stdlib.h>
#include <string.h>

/* The vertex where a side starts, and where it ends. */
static int32_t side_start(const struct mesh *mesh, int64_t side)
{
    return mesh->triangles[side];
}

static int32_t side_end(const struct mesh *mesh, int64_t side)
{
    return mesh->triangles[side % 3 == 2 ? side - 2 : side + 1];
}

static int32_t side_low(const struct mesh *mesh, int64_t side)
{
    int32_t a = side_start(mesh, side), b = side_end(mesh, side);
    return a < b ? a : b;
}

static int32_t side_high(const struct mesh *mesh, int64_t side)
{
    int32_t a = side_start(mesh, side), b = side_end(mesh, side);
    return a < b ? b : a;
}

/* Stable counting sort of `count` sides by one of their vertices; `starts` has vertex_count + 1. */
static void sort_sides(const struct mesh *mesh, int32_t (*key)(const struct mesh *, int64_t),
                       const int32_t *from, int32_t *to, int64_t count, int64_t *starts)
{
    memset(starts, 0, ((size_t)mesh->vertex_count + 1) * sizeof *starts);
    for (int64_t i = 0; i < count; i++)
        starts[key(mesh, from[i]) + 1]++;
    for (int64_t v = 0; v < mesh->vertex_count; v++)
        starts[v + 1] += starts[v];
    for (int64_t i = 0; i < count; i++)
        to[starts[key(mesh, from[i])]++] = from[i];
}

/* The sides of all triangles that are not degenerate, in order. */
static int64_t collect_sides(const struct mesh *mesh, int32_t *sides)
{
    int64_t count = 0;
    for (int64_t t = 0; t < mesh->triangle_count; t++)
        if (!triangle_is_degenerate(mesh->triangles + 3 * t))
            for (int64_t corner = 0; corner < 3; corner++)
                sides[count++] = (int32_t)(3 * t + corner);
    return count;
}

/* One edge for each run of equal pairs in the sorted uses; with edges NULL it only counts them. */
static int64_t collect_edges(const struct mesh *mesh, const int32_t *uses, int64_t use_count,
                             struct edge *edges)
{
    int64_t count = 0;
    int32_t low = -1, high = -1;
    for (int64_t i = 0; i < use_count; i++) {
        if (side_low(mesh, uses[i]) != low || side_high(mesh, uses[i]) != high) {
            low = side_low(mesh, uses[i]);
            high = side_high(mesh, uses[i]);
            if (edges)
                edges[count] = (struct edge){.low = low, .high = high, .first_use = i};
            count++;
        }
        if (!edges)
            continue;
        if (side_start(mesh, uses[i]) == low)
            edges[count - 1].forward_count++;
        else
            edges[count - 1].backward_count++;
    }
    return count;
}

int edge_list_init(struct edge_list *list, const struct mesh *mesh, struct error *err)
{
    *list = (struct edge_list){0};
    size_t side_count = 3 * (size_t)mesh->triangle_count;
    int32_t *sides = malloc(side_count * sizeof *sides + 1);
    int64_t *starts = malloc(((size_t)mesh->vertex_count + 1) * sizeof *starts);
    list->uses = malloc(side_count * sizeof *list->uses + 1);
    if (sides && starts && list->uses) {
        int64_t use_count = collect_sides(mesh, list->uses);
        sort_sides(mesh, side_high, list->uses, sides, use_count, starts);
        sort_sides(mesh, side_low, sides, list->uses, use_count, starts);
        int64_t edge_count = collect_edges(mesh, list->uses, use_count, NULL);
        list->edges = malloc((size_t)edge_count * sizeof *list->edges + 1);
        if (list->edges)
            list->edge_count = collect_edges(mesh, list->uses, use_count, list->edges);
    }
    free(sides);
    free(starts);
    if (list->edges)
        return 0;
    edge_list_release(list);
    return error_set(err, "out of memory: listing the edges of %d triangles", mesh->triangle_count);
}

void edge_list_release(struct edge_list *list)
{
    free(list->edges);
    free(list->uses);
    *list = (struct edge_list){0};
}
