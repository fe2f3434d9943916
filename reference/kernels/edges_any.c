/* Rows of larger neighbours, filled without search; see edges_any.h. */
#include "reference/kernels/edges_any.h"

#include "reference/kernels/neighbour_rows.h"
#include "reference/kernels/order.h"
#include "reference/kernels/parts.h"

size_t edges_any_scratch_bytes(int64_t vertex_count, int64_t triangle_count)
{
    return neighbour_rows_bytes(vertex_count, triangle_count);
}

size_t edges_any_output_bytes(int64_t vertex_count, int64_t triangle_count)
{
    (void)vertex_count;
    return 24 * (size_t)triangle_count + 64;
}

int64_t edges_any_moved_bytes(int64_t vertex_count, int64_t triangle_count, int64_t edge_count)
{
    (void)vertex_count;
    return 12 * triangle_count + 8 * edge_count;
}

static void fill_rows(const struct mesh *mesh, struct neighbour_rows *rows)
{
    const int32_t *t = mesh->triangles;
    for (int32_t left = mesh->triangle_count; left > 0; left--, t += 3) {
        struct sorted s = sort_corners(t);
        neighbour_rows_add(rows, s.low, s.middle, s.high);
    }
}

static void fill_scattered_rows(const struct mesh *mesh, struct neighbour_rows *rows)
{
    enum { AHEAD = 16 };
    const int32_t *t = mesh->triangles;
    int32_t left = mesh->triangle_count;
    for (; left > AHEAD; left--, t += 3) {
        struct sorted next = sort_corners(t + 3 * AHEAD), s = sort_corners(t);
        neighbour_rows_prefetch(rows, next.low);
        neighbour_rows_prefetch(rows, next.middle);
        neighbour_rows_add(rows, s.low, s.middle, s.high);
    }
    const struct mesh rest = {NULL, mesh->triangles + (t - mesh->triangles), 0, left};
    fill_rows(&rest, rows);
}

/* Neighbours on their way to a row. */
struct pair {
    int32_t vertex, neighbour;
};

/* Sorts the neighbours by parts of the vertices; within one they stay in the order of the
 * triangles. */
static void part_pairs(struct parts *parts, const struct mesh *mesh, struct pair *pairs)
{
    parts_begin(parts, mesh);
    const int32_t *t = mesh->triangles;
    for (int32_t left = mesh->triangle_count; left > 0; left--, t += 3) {
        struct sorted s = sort_corners(t);
        int32_t *end = &parts->ends[s.low >> parts->shift];
        pairs[*end] = (struct pair){s.low, s.middle};
        pairs[*end + 1] = (struct pair){s.low, s.high};
        *end += 2;
        end = &parts->ends[s.middle >> parts->shift];
        pairs[(*end)++] = (struct pair){s.middle, s.high};
    }
}

/* Puts the edges of all rows there are, but writes nothing behind them: pairs may stand there. */
static int32_t *put_exactly(int32_t *(*put)(const struct neighbour_rows *rows, int32_t begin,
                                            int32_t end, int32_t *edges),
                            const struct neighbour_rows *rows, int32_t *edges)
{
    enum { ROWS_AT_ONCE = 64 };
    int32_t aside[2 * (ROWS_AT_ONCE + 1) * ROW_PLACES];
    int32_t stop = rows->first_vertex + rows->row_count;
    int32_t at_once = rows->overflow_count == 0 ? ROWS_AT_ONCE : 1;
    for (int32_t v = rows->first_vertex; v < stop; v += at_once) {
        if (*neighbour_row_count(rows, v) == ROW_OVERFLOWS) {
            edges = neighbour_rows_put_overflow(rows, v, edges);
            continue;
        }
        size_t count =
            (size_t)(put(rows, v, stop - v < at_once ? stop : v + at_once, aside) - aside);
        memcpy(edges, aside, count * sizeof *edges);
        edges += count;
    }
    return edges;
}

/* The pairs need the room of three edges a triangle: that of the output. A part yields no more
 * edges than it has pairs, so that edges can take the place of pairs that were read. */
static int64_t run_by_parts(int32_t *(*put)(const struct neighbour_rows *rows, int32_t begin,
                                            int32_t end, int32_t *edges),
                            const struct mesh *mesh, void *scratch, void *output)
{
    struct neighbour_rows rows = neighbour_rows_begin(scratch, mesh);
    struct parts parts;
    const struct pair *pair = output;
    part_pairs(&parts, mesh, output);
    int32_t *edges = output, part_size = 1 << parts.shift;
    for (int64_t first = 0; first < mesh->vertex_count; first += part_size) {
        const struct pair *stop = (const struct pair *)output + parts.ends[first >> parts.shift];
        int64_t left = mesh->vertex_count - first;
        neighbour_rows_restart(&rows, (int32_t)first, left < part_size ? (int32_t)left : part_size);
        for (; pair < stop; pair++)
            neighbour_rows_add_one(&rows, pair->vertex, pair->neighbour);
        neighbour_rows_sort_overflow(&rows);
        edges = put_exactly(put, &rows, edges);
    }
    return (edges - (int32_t *)output) / 2;
}

int64_t edges_any_by(int32_t *(*put)(const struct neighbour_rows *rows, int32_t begin, int32_t end,
                                     int32_t *edges),
                     const struct mesh *mesh, void *scratch, void *output)
{
    if (order_is_worth_parting(mesh))
        return run_by_parts(put, mesh, scratch, output);
    struct neighbour_rows rows = neighbour_rows_begin(scratch, mesh);
    if (order_is_scattered(mesh))
        fill_scattered_rows(mesh, &rows);
    else
        fill_rows(mesh, &rows);
    neighbour_rows_sort_overflow(&rows);
    const int32_t *end = put(&rows, 0, mesh->vertex_count, output);
    return (end - (int32_t *)output) / 2;
}

int64_t edges_any_plain(const struct mesh *mesh, void *scratch, void *output)
{
    return edges_any_by(neighbour_rows_put_edges, mesh, scratch, output);
}
