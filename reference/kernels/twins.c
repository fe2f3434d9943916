/* Twins found in the rows of smaller vertices; see twins.h. */
#include "reference/kernels/twins.h"

#include "reference/kernels/side_rows.h"
#include "reference/kernels/twin_pairs.h"

#include <string.h>

size_t twins_scratch_bytes(int64_t vertex_count, int64_t triangle_count)
{
    return side_rows_bytes(vertex_count, triangle_count);
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

/* The sides met last, by a hash of the neighbour: a small table that stays in the nearest cache and
 * needs no clearing between rows, as every entry names its row. */
enum { MEMORY_BITS = 8 };
struct memory {
    uint64_t edge[1 << MEMORY_BITS]; /* vertex * 2^32 + neighbour */
    uint32_t side[1 << MEMORY_BITS];
};

/* Pairs the sides of a row without a branch on the data. Returns false, with nothing entered, when
 * the row has an edge that is not manifold or incoherent, or the small table forgot a side. */
static bool match_quickly(const struct side_rows *rows, int32_t vertex, struct memory *memory,
                          struct twin_pairs *pairs)
{
    size_t count = rows->counts[vertex], pair_count = pairs->count;
    bool odd = false;
    for (size_t k = 0; k < count; k++) {
        uint64_t place = *side_row_place(rows->storeys, rows->vertex_count, vertex, k);
        uint32_t neighbour = (uint32_t)place, side = (uint32_t)(place >> 32);
        uint64_t edge = (uint64_t)vertex << 32 | neighbour;
        uint32_t slot = neighbour * UINT32_C(0x9E3779B1) >> (32 - MEMORY_BITS);
        uint32_t met = memory->side[slot];
        bool same_edge = memory->edge[slot] == edge;
        bool same_row = memory->edge[slot] >> 32 == (uint64_t)vertex;
        bool opposite = (met ^ side) & SIDE_BACKWARD;
        pairs->one[pair_count] = side & ~SIDE_BACKWARD;
        pairs->other[pair_count] = met & ~SIDE_BACKWARD;
        pair_count += same_edge;
        odd |= (same_row & !same_edge) | (same_edge & !opposite) | (neighbour == (uint32_t)vertex);
        /* Once paired, an edge that comes again is one for the careful way. */
        memory->edge[slot] = same_edge ? edge | UINT32_MAX : edge;
        memory->side[slot] = side;
    }
    pairs->count = odd ? pairs->count : pair_count;
    return !odd;
}

void twins_match(const struct side_rows *rows, int32_t begin, int32_t end, int32_t *twin)
{
    struct twin_pairs pairs = {.twin = twin};
    struct memory memory;
    memset(&memory, -1, sizeof memory);
    for (int32_t v = begin; v < end; v++) {
        if (rows->counts[v] > SIDE_ROW_PLACES)
            continue;
        if (!match_quickly(rows, v, &memory, &pairs))
            side_rows_match_carefully(rows, v, twin);
        if (pairs.count >= TWIN_PAIRS)
            twin_pairs_flush(&pairs);
    }
    twin_pairs_flush(&pairs);
}

int64_t twins_plain(const struct mesh *mesh, void *scratch, void *output)
{
    struct side_rows rows = side_rows_of(mesh, scratch);
    memset(output, TWIN_NONE, 12 * (size_t)mesh->triangle_count);
    twins_match(&rows, 0, mesh->vertex_count, output);
    side_rows_match_overflow(&rows, output);
    return 3 * (int64_t)mesh->triangle_count;
}
