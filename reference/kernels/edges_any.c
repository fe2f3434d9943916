/* Rows of larger neighbours, by counting; see edges_any.h. */
#include "reference/kernels/edges_any.h"

#include <string.h>

size_t edges_any_scratch_bytes(int64_t vertex_count, int64_t triangle_count)
{
    return 8 * (size_t)vertex_count + 12 * (size_t)triangle_count + 64;
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

/* The corners of a triangle in ascending order. */
struct sorted {
    int32_t low, middle, high;
};

static struct sorted sort_corners(const int32_t t[3])
{
    int32_t less = t[0] < t[1] ? t[0] : t[1], more = t[0] < t[1] ? t[1] : t[0];
    int32_t rest = less < t[2] ? t[2] : less;
    return (struct sorted){less < t[2] ? less : t[2], rest < more ? rest : more,
                           rest < more ? more : rest};
}

static void fill_rows(const struct mesh *mesh, int32_t *end, int32_t *entry)
{
    const int32_t *stop = mesh->triangles + 3 * (size_t)mesh->triangle_count;
    for (const int32_t *t = mesh->triangles; t < stop; t += 3) {
        struct sorted s = sort_corners(t);
        end[s.low] += 2;
        end[s.middle]++;
    }
    int32_t total = 0;
    for (int32_t v = 0; v < mesh->vertex_count; v++) {
        int32_t count = end[v];
        end[v] = total;
        total += count;
    }
    for (const int32_t *t = mesh->triangles; t < stop; t += 3) {
        struct sorted s = sort_corners(t);
        entry[end[s.low]++] = s.middle;
        entry[end[s.low]++] = s.high;
        entry[end[s.middle]++] = s.high;
    }
}

int64_t edges_any_plain(const struct mesh *mesh, void *scratch, void *output)
{
    int32_t *end = scratch, *met_in = end + mesh->vertex_count;
    int32_t *entry = met_in + mesh->vertex_count, *edges = output;
    memset(end, 0, (size_t)mesh->vertex_count * sizeof *end);
    memset(met_in, -1, (size_t)mesh->vertex_count * sizeof *met_in);
    fill_rows(mesh, end, entry);
    int64_t count = 0;
    int32_t k = 0;
    for (int32_t v = 0; v < mesh->vertex_count; v++)
        for (; k < end[v]; k++) {
            int32_t other = entry[k];
            edges[2 * count] = v;
            edges[2 * count + 1] = other;
            count += other != v && met_in[other] != v;
            met_in[other] = v;
        }
    return count;
}
