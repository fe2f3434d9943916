/* Numbering edges; see edge_numbers.h. */
#include "reference/representation/edge_numbers.h"

#include "reference/mesh/check.h"

#include <stdlib.h>
#include <string.h>

struct sides {
    const int32_t *starts, *ends;
    int32_t vertex_count;
};

static int32_t low_of(const struct sides *sides, int32_t side)
{
    int32_t a = sides->starts[side], b = sides->ends[side];
    return a < b ? a : b;
}

static int32_t high_of(const struct sides *sides, int32_t side)
{
    int32_t a = sides->starts[side], b = sides->ends[side];
    return a < b ? b : a;
}

/* Stable counting sort by the lower or the higher vertex; `places` has vertex_count + 1 entries. */
static void sort_sides(const struct sides *sides, int32_t (*key)(const struct sides *, int32_t),
                       const int32_t *from, int32_t *to, int64_t count, int32_t *places)
{
    memset(places, 0, ((size_t)sides->vertex_count + 1) * sizeof *places);
    for (int64_t i = 0; i < count; i++)
        places[key(sides, from[i]) + 1]++;
    for (int64_t v = 0; v < sides->vertex_count; v++)
        places[v + 1] += places[v];
    for (int64_t i = 0; i < count; i++)
        to[places[key(sides, from[i])]++] = from[i];
}

/* Sides of one edge stand together now, the first in front: each gets that one's number, which is
 * lower than its own, so that a last pass in order can number the edges. */
static int64_t number_runs(const struct sides *sides, const int32_t *sorted, int64_t count,
                           int32_t *edge_of_side)
{
    int32_t first = -1;
    for (int64_t i = 0; i < count; i++) {
        int32_t side = sorted[i];
        if (first < 0 || low_of(sides, side) != low_of(sides, first) ||
            high_of(sides, side) != high_of(sides, first))
            first = side;
        edge_of_side[side] = first;
    }
    int32_t edge_count = 0;
    for (int64_t side = 0; side < count; side++)
        edge_of_side[side] =
            edge_of_side[side] == side ? edge_count++ : edge_of_side[edge_of_side[side]];
    return edge_count;
}

int64_t edge_numbers_make(const int32_t *starts, const int32_t *ends, int64_t side_count,
                          int32_t vertex_count, int32_t *edge_of_side, struct error *err)
{
    struct sides sides = {starts, ends, vertex_count};
    int32_t *order = calloc((size_t)side_count + 1, sizeof *order);
    int32_t *by_high = calloc((size_t)side_count + 1, sizeof *by_high);
    int32_t *places = malloc(((size_t)vertex_count + 1) * sizeof *places);
    int64_t edge_count = -1;
    if (order && by_high && places) {
        for (int64_t i = 0; i < side_count; i++)
            order[i] = (int32_t)i;
        sort_sides(&sides, high_of, order, by_high, side_count, places);
        sort_sides(&sides, low_of, by_high, order, side_count, places);
        edge_count = number_runs(&sides, order, side_count, edge_of_side);
    } else {
        error_set(err, "out of memory: numbering the edges of %lld sides", (long long)side_count);
    }
    free(order);
    free(by_high);
    free(places);
    return edge_count;
}

int64_t edge_numbers_of_mesh(const struct mesh *mesh, int32_t **edge_of_side, struct error *err)
{
    *edge_of_side = NULL;
    struct finding degenerate = mesh_degenerate_triangles(mesh);
    if (degenerate.count > 0) {
        const int32_t *corner = mesh->triangles + 3 * degenerate.first;
        return error_set(err, "triangle %lld has corners %d %d %d: two are the same vertex",
                         (long long)degenerate.first, corner[0], corner[1], corner[2]);
    }
    int64_t side_count = 3 * (int64_t)mesh->triangle_count, edge_count = -1;
    int32_t *ends = malloc((size_t)side_count * sizeof *ends + 1);
    int32_t *numbers = malloc((size_t)side_count * sizeof *numbers + 1);
    if (ends && numbers) {
        for (int64_t side = 0; side < side_count; side++)
            ends[side] = mesh->triangles[side % 3 == 2 ? side - 2 : side + 1];
        edge_count =
            edge_numbers_make(mesh->triangles, ends, side_count, mesh->vertex_count, numbers, err);
    } else {
        error_set(err, "out of memory: numbering the edges of %d triangles", mesh->triangle_count);
    }
    free(ends);
    if (edge_count >= 0)
        *edge_of_side = numbers;
    else
        free(numbers);
    return edge_count;
}

int edge_numbers_check(const int32_t *pairs, int64_t stride, int64_t edge_count,
                       int32_t vertex_count, struct error *err)
{
    int32_t *ends = calloc(3 * (size_t)edge_count + 1, sizeof *ends);
    if (!ends)
        return error_set(err, "out of memory: comparing %lld edges", (long long)edge_count);
    int32_t *numbers = ends + 2 * edge_count;
    for (int64_t e = 0; e < edge_count; e++) {
        ends[e] = pairs[stride * e];
        ends[edge_count + e] = pairs[stride * e + 1];
    }
    int result = -1;
    if (edge_numbers_make(ends, ends + edge_count, edge_count, vertex_count, numbers, err) >= 0) {
        int64_t e = 0; /* numbers follow the first appearance: the first gap is behind a double */
        while (e < edge_count && numbers[e] == e)
            e++;
        result = e == edge_count
                     ? 0
                     : error_set(err, "edges %d and %lld both join vertices %d and %d", numbers[e],
                                 (long long)e, ends[e], ends[edge_count + e]);
    }
    free(ends);
    return result;
}
