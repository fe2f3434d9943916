/* Rows of larger neighbours, filled without search; see edges_any.h. */
#include "reference/kernels/edges_any.h"

#include "reference/kernels/neighbour_rows.h"
#include "reference/kernels/order.h"

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

void edges_any_fill_rows(const struct mesh *mesh, struct neighbour_rows *rows)
{
    if (mesh_is_scattered(mesh))
        fill_scattered_rows(mesh, rows);
    else
        fill_rows(mesh, rows);
    neighbour_rows_sort_overflow(rows);
}

int64_t edges_any_plain(const struct mesh *mesh, void *scratch, void *output)
{
    struct neighbour_rows rows = neighbour_rows_begin(scratch, mesh);
    edges_any_fill_rows(mesh, &rows);
    const int32_t *end = neighbour_rows_put_edges(&rows, 0, mesh->vertex_count, output);
    return (end - (int32_t *)output) / 2;
}
