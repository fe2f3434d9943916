/* Rows of larger neighbours; see neighbour_rows.h. */
#include "reference/kernels/neighbour_rows.h"

static size_t padded(size_t bytes)
{
    return (bytes + 127) / 64 * 64;
}

size_t neighbour_rows_bytes(int64_t vertex_count, int64_t triangle_count)
{
    size_t v = (size_t)vertex_count, t = (size_t)triangle_count;
    return padded(v) + padded(4 * ROW_PLACES * v) + 2 * padded(4 * v) + padded(24 * t) +
           padded(12 * t);
}

struct neighbour_rows neighbour_rows_begin(void *scratch, const struct mesh *mesh)
{
    size_t v = (size_t)mesh->vertex_count, t = (size_t)mesh->triangle_count;
    char *at = scratch;
    struct neighbour_rows rows = {.vertex_count = mesh->vertex_count};
    rows.counts = (uint8_t *)at;
    rows.places = (int32_t *)(at += padded(v));
    rows.overflow = (int32_t *)(at += padded(4 * ROW_PLACES * v));
    rows.sorted_end = (int32_t *)(at += padded(24 * t));
    rows.met_by = (int32_t *)(at += padded(4 * v));
    rows.sorted = (int32_t *)(at + padded(4 * v));
    neighbour_rows_restart(&rows, 0, mesh->vertex_count);
    return rows;
}

void neighbour_rows_restart(struct neighbour_rows *rows, int32_t first_vertex, int32_t row_count)
{
    rows->first_vertex = first_vertex;
    rows->row_count = row_count;
    rows->overflow_count = 0;
    if (row_count > 0)
        memset(rows->counts, 0, (size_t)row_count);
}

/* Keeps the first of equal neighbours; returns how many stay. */
static int drop_repeated(int32_t *place)
{
    int kept = 0;
    for (int k = 0; k < ROW_PLACES; k++) {
        int32_t neighbour = place[k];
        int m = 0;
        while (m < kept && place[m] != neighbour)
            m++;
        place[kept] = neighbour;
        kept += m == kept;
    }
    return kept;
}

void neighbour_rows_add_to_full(struct neighbour_rows *rows, int32_t vertex, int32_t neighbour)
{
    uint8_t *count = neighbour_row_count(rows, vertex);
    int32_t *place = neighbour_row(rows, vertex);
    if (*count == ROW_PLACES) {
        *count = (uint8_t)drop_repeated(place);
        if (*count == ROW_PLACES)
            *count = ROW_OVERFLOWS;
    }
    if (*count < ROW_PLACES) {
        place[(*count)++] = neighbour;
        return;
    }
    /* Threads share the list; what belongs to one vertex comes from one thread and in order. */
    int64_t k = __atomic_fetch_add(&rows->overflow_count, 1, __ATOMIC_RELAXED);
    rows->overflow[2 * k] = vertex;
    rows->overflow[2 * k + 1] = neighbour;
}

/* A stable counting sort. */
void neighbour_rows_sort_overflow(struct neighbour_rows *rows)
{
    if (rows->overflow_count == 0)
        return;
    if (!rows->met_by_is_clear)
        memset(rows->met_by, -1, 4 * (size_t)rows->vertex_count);
    rows->met_by_is_clear = true;
    int32_t *end = rows->sorted_end;
    memset(end, 0, 4 * (size_t)rows->row_count);
    const int32_t *stop = rows->overflow + 2 * rows->overflow_count;
    for (const int32_t *pair = rows->overflow; pair < stop; pair += 2)
        end[pair[0] - rows->first_vertex]++;
    int32_t total = 0;
    for (int32_t row = 0; row < rows->row_count; row++) {
        int32_t count = end[row];
        end[row] = total;
        total += count;
    }
    for (const int32_t *pair = rows->overflow; pair < stop; pair += 2)
        rows->sorted[end[pair[0] - rows->first_vertex]++] = pair[1];
}

/* Compares each place with all before it. */
static int32_t *put_by_comparing(const int32_t *place, int count, int32_t vertex, int32_t *end)
{
    for (int k = 0; k < count; k++) {
        bool repeated = place[k] == vertex;
        for (int m = 0; m < k; m++)
            repeated |= place[m] == place[k];
        if (!repeated) {
            *end++ = vertex;
            *end++ = place[k];
        }
    }
    return end;
}

int32_t *neighbour_rows_put_overflow(const struct neighbour_rows *rows, int32_t vertex,
                                     int32_t *end)
{
    const int32_t *place = neighbour_row(rows, vertex);
    for (int k = 0; k < ROW_PLACES; k++)
        rows->met_by[place[k]] = vertex;
    end = put_by_comparing(place, ROW_PLACES, vertex, end);
    int32_t row = vertex - rows->first_vertex;
    for (int32_t k = row > 0 ? rows->sorted_end[row - 1] : 0; k < rows->sorted_end[row]; k++) {
        int32_t neighbour = rows->sorted[k];
        if (neighbour != vertex && rows->met_by[neighbour] != vertex) {
            *end++ = vertex;
            *end++ = neighbour;
            rows->met_by[neighbour] = vertex;
        }
    }
    return end;
}

/* The edges put last, by a hash of the neighbour: a small table that stays in the nearest cache
 * and needs no clearing between rows, as every entry names its row. */
enum { MEMORY_BITS = 8 };
struct memory {
    uint64_t edge[1 << MEMORY_BITS]; /* vertex * 2^32 + neighbour */
};

/* Without a branch on the data: an entry of the same row with another neighbour has lost one that
 * may come again, and the row is then done anew by comparing. */
static int32_t *put_row(const int32_t *place, int count, int32_t vertex, struct memory *memory,
                        int32_t *begin)
{
    int32_t *end = begin;
    bool forgot = false;
    for (int k = 0; k < count; k++) {
        uint32_t neighbour = (uint32_t)place[k];
        uint64_t edge = (uint64_t)vertex << 32 | neighbour;
        uint64_t *slot = memory->edge + (neighbour * UINT32_C(0x9E3779B1) >> (32 - MEMORY_BITS));
        bool repeated = *slot == edge;
        forgot |= !repeated & (*slot >> 32 == (uint64_t)vertex);
        *slot = edge;
        const int32_t pair[2] = {vertex, place[k]};
        memcpy(end, pair, sizeof pair);
        end += 2 * !(repeated | (place[k] == vertex));
    }
    return forgot ? put_by_comparing(place, count, vertex, begin) : end;
}

int32_t *neighbour_rows_put_edges(const struct neighbour_rows *rows, int32_t begin, int32_t end,
                                  int32_t *edges)
{
    struct memory memory;
    memset(&memory, -1, sizeof memory);
    for (int32_t v = begin; v < end; v++) {
        const int32_t *place = neighbour_row(rows, v);
        int count = *neighbour_row_count(rows, v);
        edges = count <= ROW_PLACES ? put_row(place, count, v, &memory, edges)
                                    : neighbour_rows_put_overflow(rows, v, edges);
    }
    return edges;
}
