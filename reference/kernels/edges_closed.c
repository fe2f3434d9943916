/* The sides that run upwards; see edges_closed.h. */
#include "reference/kernels/edges_closed.h"

#include <string.h>

size_t edges_closed_output_bytes(int64_t vertex_count, int64_t triangle_count)
{
    (void)vertex_count;
    return 16 * (size_t)triangle_count + 64;
}

int64_t edges_closed_moved_bytes(int64_t vertex_count, int64_t triangle_count, int64_t edge_count)
{
    (void)vertex_count;
    return 12 * triangle_count + 8 * edge_count;
}

/* Writes the pair in any case and steps over it only when it counts: a branch here would be
 * mispredicted for every second side of a mesh without order. */
static int32_t *put_if_upwards(int32_t *end, int32_t i, int32_t j)
{
    const int32_t pair[2] = {i, j};
    memcpy(end, pair, sizeof pair);
    return end + 2 * (i < j);
}

int64_t edges_closed_plain(const struct mesh *mesh, void *scratch, void *output)
{
    (void)scratch;
    int32_t *edges = output, *end = edges;
    const int32_t *t = mesh->triangles;
    for (int32_t left = mesh->triangle_count; left > 0; left--, t += 3) {
        end = put_if_upwards(end, t[0], t[1]);
        end = put_if_upwards(end, t[1], t[2]);
        end = put_if_upwards(end, t[2], t[0]);
    }
    return (end - edges) / 2;
}

int64_t edges_closed_count(const int32_t *triangles, int32_t triangle_count)
{
    int64_t count = 0;
    for (const int32_t *t = triangles; triangle_count > 0; triangle_count--, t += 3)
        count += (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]);
    return count;
}
