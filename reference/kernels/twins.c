/* Twins found in the rows of smaller vertices; see twins.h. */
#include "reference/kernels/twins.h"

#include "reference/kernels/order.h"
#include "reference/kernels/parts.h"
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
static bool match_quickly(const struct side_rows *rows, int32_t row, struct memory *memory,
                          struct twin_pairs *pairs)
{
    int32_t vertex = rows->first_vertex + row;
    size_t count = rows->counts[row], pair_count = pairs->count;
    bool odd = false;
    for (size_t k = 0; k < count; k++) {
        uint64_t place = *side_row_place(rows->storeys, rows->row_count, row, k);
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
    for (int32_t row = begin; row < end; row++) {
        if (rows->counts[row] > SIDE_ROW_PLACES)
            continue;
        if (!match_quickly(rows, row, &memory, &pairs))
            side_rows_match_carefully(rows, row, twin);
        if (pairs.count >= TWIN_PAIRS)
            twin_pairs_flush(&pairs);
    }
    twin_pairs_flush(&pairs);
}

/* Sorts the sides by parts of the vertices. They stand where the overflow will: what a part adds to
 * that are sides that were read before. */
static void part_sides(struct parts *parts, const struct mesh *mesh, struct loose_side *sides)
{
    parts_begin(parts, mesh);
    const int32_t *t = mesh->triangles;
    for (uint32_t k = 0, stop = (uint32_t)mesh->triangle_count; k < stop; k++, t += 3) {
        struct turned s = turn_triangle(t, 3 * k);
        int32_t smaller = s.b < s.c ? s.b : s.c;
        int32_t *end = &parts->ends[s.a >> parts->shift];
        sides[*end] = (struct loose_side){s.a, (uint32_t)s.ab, (uint32_t)(s.ab >> 32)};
        sides[*end + 1] = (struct loose_side){s.a, (uint32_t)s.ac, (uint32_t)(s.ac >> 32)};
        *end += 2;
        end = &parts->ends[smaller >> parts->shift];
        sides[(*end)++] = (struct loose_side){smaller, (uint32_t)s.bc, (uint32_t)(s.bc >> 32)};
    }
}

static void run_by_parts(void (*match)(const struct side_rows *rows, int32_t begin, int32_t end,
                                       int32_t *twin),
                         const struct mesh *mesh, void *scratch, int32_t *twin)
{
    struct side_rows rows = side_rows_begin(mesh, scratch);
    struct parts parts;
    const struct loose_side *side = rows.overflow;
    part_sides(&parts, mesh, rows.overflow);
    int32_t part_size = 1 << parts.shift;
    for (int64_t first = 0; first < mesh->vertex_count; first += part_size) {
        const struct loose_side *stop = rows.overflow + parts.ends[first >> parts.shift];
        int64_t left = mesh->vertex_count - first;
        side_rows_restart(&rows, (int32_t)first, left < part_size ? (int32_t)left : part_size);
        struct filling f = {rows.counts, rows.storeys, rows.row_count, &rows};
        for (; side < stop; side++)
            filling_add_one(f, side->row - (int32_t)first,
                            side_place((int32_t)side->neighbour, side->side));
        match(&rows, 0, rows.row_count, twin);
        side_rows_match_overflow(&rows, twin);
    }
}

int64_t twins_by(struct side_rows (*fill)(const struct mesh *mesh, void *scratch),
                 void (*match)(const struct side_rows *rows, int32_t begin, int32_t end,
                               int32_t *twin),
                 const struct mesh *mesh, void *scratch, int32_t *twin)
{
    memset(twin, TWIN_NONE, 12 * (size_t)mesh->triangle_count);
    if (order_is_worth_parting(mesh)) {
        run_by_parts(match, mesh, scratch, twin);
    } else {
        struct side_rows rows = fill(mesh, scratch);
        match(&rows, 0, rows.row_count, twin);
        side_rows_match_overflow(&rows, twin);
    }
    return 3 * (int64_t)mesh->triangle_count;
}

int64_t twins_plain(const struct mesh *mesh, void *scratch, void *output)
{
    return twins_by(side_rows_of, twins_match, mesh, scratch, output);
}
