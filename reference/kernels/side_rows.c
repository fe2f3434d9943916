/* Rows of sides; see side_rows.h. */
#include "reference/kernels/side_rows.h"

#include "reference/kernels/order.h"
#include "reference/kernels/twins.h"

#include <string.h>

/* What is known of the sides between the vertex in hand and another one, by direction. */
struct between {
    int32_t vertex; /* for which this holds */
    uint32_t count[2], side[2];
};

static size_t padded(size_t bytes)
{
    return (bytes + 127) / 64 * 64;
}

size_t side_rows_bytes(int64_t vertex_count, int64_t triangle_count)
{
    size_t v = (size_t)vertex_count, t = (size_t)triangle_count;
    return padded(v) + 2 * v * sizeof(struct storey) +
           2 * padded(3 * t * sizeof(struct loose_side)) + padded(v * sizeof(struct between)) +
           padded(4 * v);
}

void side_rows_add_slowly(struct side_rows *rows, int32_t row, uint64_t place)
{
    uint8_t *count = rows->counts + row;
    if (*count < SIDE_ROW_PLACES) {
        *side_row_place(rows->storeys, rows->row_count, row, *count) = place;
        *count = (uint8_t)(*count + 1);
        return;
    }
    *count = SIDE_ROW_PLACES + 1;
    int64_t k = __atomic_fetch_add(&rows->overflow_count, 1, __ATOMIC_RELAXED);
    rows->overflow[k] = (struct loose_side){row, (uint32_t)place, (uint32_t)(place >> 32)};
}

void side_rows_fill_from(struct filling f, const struct mesh *mesh, uint32_t first)
{
    for (uint32_t k = first, stop = (uint32_t)mesh->triangle_count; k < stop; k++)
        filling_add_triangle(f, mesh->triangles + 3 * (size_t)k, 3 * k);
}

/* All but the last AHEAD triangles. Returns how many. */
static uint32_t fill_with_prefetch(struct filling f, const struct mesh *mesh)
{
    enum { AHEAD = 16 };
    const int32_t *t = mesh->triangles;
    uint32_t k = 0, stop = (uint32_t)mesh->triangle_count;
    for (; k + AHEAD < stop; k++, t += 3) {
        struct sorted next = sort_corners(t + 3 * AHEAD);
        filling_prefetch(f, next.low);
        filling_prefetch(f, next.middle);
        filling_add_triangle(f, t, 3 * k);
    }
    return k;
}

struct side_rows side_rows_begin(const struct mesh *mesh, void *scratch)
{
    size_t v = (size_t)mesh->vertex_count, t = (size_t)mesh->triangle_count;
    char *at = scratch;
    struct side_rows rows = {.vertex_count = mesh->vertex_count};
    rows.counts = (uint8_t *)at;
    rows.storeys = (struct storey *)(at += padded(v));
    rows.overflow = (struct loose_side *)(at += 2 * v * sizeof(struct storey));
    rows.sorting = at + padded(3 * t * sizeof(struct loose_side));
    side_rows_restart(&rows, 0, mesh->vertex_count);
    return rows;
}

void side_rows_restart(struct side_rows *rows, int32_t first_vertex, int32_t row_count)
{
    rows->first_vertex = first_vertex;
    rows->row_count = row_count;
    rows->overflow_count = 0;
    if (row_count > 0)
        memset(rows->counts, 0, (size_t)row_count);
}

struct side_rows side_rows_of(const struct mesh *mesh, void *scratch)
{
    struct side_rows rows = side_rows_begin(mesh, scratch);
    struct filling f = {rows.counts, rows.storeys, rows.row_count, &rows};
    side_rows_fill_from(f, mesh, order_is_scattered(mesh) ? fill_with_prefetch(f, mesh) : 0);
    return rows;
}

static int32_t twin_of(uint32_t same, uint32_t opposite, uint32_t opposite_side)
{
    if (opposite == 0)
        return TWIN_NONE;
    return same == 1 && opposite == 1 ? (int32_t)(opposite_side & ~SIDE_BACKWARD) : TWIN_MANY;
}

static int32_t neighbour_of(uint64_t place)
{
    return (int32_t)(uint32_t)place;
}

static uint32_t side_of(uint64_t place)
{
    return (uint32_t)(place >> 32);
}

void side_rows_match_carefully(const struct side_rows *rows, int32_t row, int32_t *twin)
{
    size_t count = rows->counts[row];
    int32_t vertex = rows->first_vertex + row;
    for (size_t k = 0; k < count; k++) {
        uint64_t own = *side_row_place(rows->storeys, rows->row_count, row, k);
        uint32_t same = 0, opposite = 0, opposite_side = 0;
        for (size_t m = 0; m < count; m++) {
            uint64_t other = *side_row_place(rows->storeys, rows->row_count, row, m);
            if (neighbour_of(other) != neighbour_of(own))
                continue;
            if ((side_of(other) ^ side_of(own)) & SIDE_BACKWARD) {
                opposite++;
                opposite_side = side_of(other);
            } else {
                same++;
            }
        }
        twin[side_of(own) & ~SIDE_BACKWARD] =
            neighbour_of(own) == vertex ? TWIN_NONE : twin_of(same, opposite, opposite_side);
    }
}

static void note(struct between *between, int32_t vertex, uint64_t place)
{
    struct between *b = between + neighbour_of(place);
    if (b->vertex != vertex)
        *b = (struct between){.vertex = vertex};
    int backward = side_of(place) >= SIDE_BACKWARD;
    b->count[backward]++;
    b->side[backward] = side_of(place);
}

static void match(const struct between *between, int32_t vertex, uint64_t place, int32_t *twin)
{
    const struct between *b = between + neighbour_of(place);
    int backward = side_of(place) >= SIDE_BACKWARD;
    twin[side_of(place) & ~SIDE_BACKWARD] =
        neighbour_of(place) == vertex
            ? TWIN_NONE
            : twin_of(b->count[backward], b->count[!backward], b->side[!backward]);
}

/* By row, a counting sort; end[r] is then where the sides of row r end. */
static void sort_overflow(const struct side_rows *rows, int32_t *end, struct loose_side *sorted)
{
    memset(end, 0, 4 * (size_t)rows->row_count);
    for (int64_t k = 0; k < rows->overflow_count; k++)
        end[rows->overflow[k].row]++;
    int32_t total = 0;
    for (int32_t row = 0; row < rows->row_count; row++) {
        int32_t count = end[row];
        end[row] = total;
        total += count;
    }
    for (int64_t k = 0; k < rows->overflow_count; k++)
        sorted[end[rows->overflow[k].row]++] = rows->overflow[k];
}

static void match_overflow_of(const struct side_rows *rows, int32_t row,
                              const struct loose_side *loose, const struct loose_side *stop,
                              struct between *between, int32_t *twin)
{
    int32_t vertex = rows->first_vertex + row;
    for (size_t k = 0; k < SIDE_ROW_PLACES; k++)
        note(between, vertex, *side_row_place(rows->storeys, rows->row_count, row, k));
    for (const struct loose_side *l = loose; l < stop; l++)
        note(between, vertex, side_place((int32_t)l->neighbour, l->side));
    for (size_t k = 0; k < SIDE_ROW_PLACES; k++)
        match(between, vertex, *side_row_place(rows->storeys, rows->row_count, row, k), twin);
    for (const struct loose_side *l = loose; l < stop; l++)
        match(between, vertex, side_place((int32_t)l->neighbour, l->side), twin);
}

void side_rows_match_overflow(struct side_rows *rows, int32_t *twin)
{
    if (rows->overflow_count == 0)
        return;
    size_t v_count = (size_t)rows->vertex_count;
    struct between *between = rows->sorting;
    int32_t *end = (int32_t *)((char *)between + padded(v_count * sizeof *between));
    struct loose_side *sorted = (struct loose_side *)((char *)end + padded(4 * v_count));
    if (!rows->sorting_is_clear)
        memset(between, -1, v_count * sizeof *between);
    rows->sorting_is_clear = true;
    sort_overflow(rows, end, sorted);
    for (int32_t row = 0, begin = 0; row < rows->row_count; begin = end[row++])
        if (begin < end[row])
            match_overflow_of(rows, row, sorted + begin, sorted + end[row], between, twin);
}
