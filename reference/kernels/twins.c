/* Twins by rows of sides at their smaller vertex; see twins.h. */
#include "reference/kernels/twins.h"

#include <string.h>

size_t twins_scratch_bytes(int64_t vertex_count, int64_t triangle_count)
{
    return 16 * (size_t)vertex_count + 12 * (size_t)triangle_count + 64;
}

size_t twins_output_bytes(int64_t vertex_count, int64_t triangle_count)
{
    (void)vertex_count;
    return 12 * (size_t)triangle_count + 64;
}

int64_t twins_moved_bytes(int64_t vertex_count, int64_t triangle_count, int64_t side_count)
{
    (void)vertex_count;
    return 12 * triangle_count + 4 * side_count;
}

static int32_t side_end(const struct mesh *mesh, int32_t side)
{
    return mesh->triangles[side % 3 == 2 ? side - 2 : side + 1];
}

/* The sides of the mesh by their first vertex; row v ends at end[v]. */
static void fill_rows(const struct mesh *mesh, int32_t *end, int32_t *entry)
{
    int32_t side_count = 3 * mesh->triangle_count, total = 0;
    memset(end, 0, (size_t)mesh->vertex_count * sizeof *end);
    for (int32_t side = 0; side < side_count; side++)
        end[mesh->triangles[side]]++;
    for (int32_t v = 0; v < mesh->vertex_count; v++) {
        int32_t count = end[v];
        end[v] = total;
        total += count;
    }
    for (int32_t side = 0; side < side_count; side++)
        entry[end[mesh->triangles[side]]++] = side;
}

/* What is known of the sides between the vertex in hand and another one. */
struct between {
    int32_t vertex;   /* the vertex for which this holds; other values mean: nothing yet */
    int32_t outgoing; /* the side that runs there, or TWIN_MANY */
    int32_t incoming; /* how many run back */
};

static int32_t side_before(int32_t side)
{
    return side % 3 == 0 ? side + 2 : side - 1;
}

/* Gives the sides that end at v their twins among the sides that start there. */
static void match_around(const struct mesh *mesh, int32_t v, const int32_t *sides, int32_t count,
                         struct between *between, int32_t *twin)
{
    for (int32_t k = 0; k < count; k++) {
        struct between *b = between + side_end(mesh, sides[k]);
        *b = (struct between){v, b->vertex == v ? TWIN_MANY : sides[k], 0};
    }
    for (int32_t k = 0; k < count; k++)
        between[mesh->triangles[side_before(sides[k])]].incoming++;
    for (int32_t k = 0; k < count; k++) {
        int32_t side = side_before(sides[k]);
        const struct between *b = between + mesh->triangles[side];
        twin[side] = b->vertex != v || mesh->triangles[side] == v ? TWIN_NONE
                     : b->incoming > 1                            ? TWIN_MANY
                                                                  : b->outgoing;
    }
}

int64_t twins_plain(const struct mesh *mesh, void *scratch, void *output)
{
    struct between *between = scratch;
    int32_t *end = (int32_t *)(between + mesh->vertex_count), *entry = end + mesh->vertex_count;
    memset(between, -1, (size_t)mesh->vertex_count * sizeof *between);
    fill_rows(mesh, end, entry);
    for (int32_t v = 0, begin = 0; v < mesh->vertex_count; begin = end[v++])
        match_around(mesh, v, entry + begin, end[v] - begin, between, output);
    return 3 * (int64_t)mesh->triangle_count;
}
