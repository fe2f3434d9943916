/* For each vertex its sides to larger vertices, of both directions: the work space of the twins
 * kernels.
 *
 * All sides of an edge meet in the row of its smaller vertex, so that once all triangles are in,
 * twins are found within rows. A row has two storeys of eight places, in two tables: the upper one
 * is touched only for vertices that need it. What does not fit goes to one list for all, the
 * overflow. Nothing is searched while rows are filled, and only their counts need clearing.
 *
 * Rejected: rows of the sides that leave a vertex, which are filled at three places a triangle and
 * searched at three more; matching a side when it comes, by searching its row, which makes a chain
 * of compare and store. */
#ifndef REFERENCE_KERNELS_SIDE_ROWS_H
#define REFERENCE_KERNELS_SIDE_ROWS_H

#include "reference/mesh/mesh.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { STOREY_PLACES = 8, SIDE_ROW_PLACES = 16 };

/* A place of a row: the neighbour in the lower half, the side's number in the upper, which has
 * SIDE_BACKWARD added when the side runs from the larger vertex to the smaller. */
#define SIDE_BACKWARD UINT32_C(0x80000000)

static inline uint64_t side_place(int32_t neighbour, uint32_t side)
{
    return (uint64_t)side << 32 | (uint32_t)neighbour;
}

/* One cache line. */
struct storey {
    uint64_t places[STOREY_PLACES];
};

/* A side on its way to a row. */
struct loose_side {
    int32_t row;
    uint32_t neighbour, side;
};

struct side_rows {
    uint8_t *counts;        /* of each row; SIDE_ROW_PLACES + 1: it has sides in the overflow */
    struct storey *storeys; /* of row r: storeys[r] and storeys[row_count + r] */
    struct loose_side *overflow; /* in the order of coming */
    int64_t overflow_count;
    void *sorting; /* scratch of side_rows_match_overflow */
    bool sorting_is_clear;
    int32_t first_vertex; /* row r is that of vertex first_vertex + r */
    int32_t row_count;
    int32_t vertex_count; /* of the mesh */
};

static inline uint64_t *side_row_place(struct storey *storeys, int32_t row_count, int32_t row,
                                       size_t k)
{
    size_t upper = k / STOREY_PLACES * (size_t)row_count;
    return storeys[upper + (size_t)row].places + k % STOREY_PLACES;
}

/* Bytes of scratch; of these only 65 a vertex are touched when no row needs its upper storey. */
size_t side_rows_bytes(int64_t vertex_count, int64_t triangle_count);

/* Lays rows out in scratch and fills them with all sides of the mesh. */
struct side_rows side_rows_of(const struct mesh *mesh, void *scratch);
#if defined(__x86_64__)
struct side_rows side_rows_of_avx512(const struct mesh *mesh, void *scratch);
#endif

/* Gives the sides in one row their twins, whatever the edges there; count <= SIDE_ROW_PLACES. */
void side_rows_match_carefully(const struct side_rows *rows, int32_t row, int32_t *twin);

/* Gives the sides in rows with an overflow their twins. Linear in rows and sides, and the first
 * time in the vertices of the mesh. */
void side_rows_match_overflow(struct side_rows *rows, int32_t *twin);

/* -- filling, for the variants ------------------------------------------------------------- */

/* Lays empty rows of all vertices out in scratch. */
struct side_rows side_rows_begin(const struct mesh *mesh, void *scratch);

/* Makes them the empty rows of some vertices only. */
void side_rows_restart(struct side_rows *rows, int32_t first_vertex, int32_t row_count);

/* Adds a side to a row that may be full. */
void side_rows_add_slowly(struct side_rows *rows, int32_t row, uint64_t place);

/* The table of rows while it is filled, held by value: stores to counts, which are characters,
 * could otherwise change it in the compiler's eyes. */
struct filling {
    uint8_t *counts;
    struct storey *storeys;
    int32_t row_count;
    struct side_rows *rows;
};

static inline void filling_add_one(struct filling f, int32_t row, uint64_t place)
{
    size_t count = f.counts[row];
    if (__builtin_expect(count > SIDE_ROW_PLACES - 1, 0)) {
        side_rows_add_slowly(f.rows, row, place);
        return;
    }
    *side_row_place(f.storeys, f.row_count, row, count) = place;
    f.counts[row] = (uint8_t)(count + 1);
}

static inline void filling_add_two(struct filling f, int32_t row, uint64_t first, uint64_t second)
{
    size_t count = f.counts[row];
    if (__builtin_expect(count > SIDE_ROW_PLACES - 2, 0)) {
        side_rows_add_slowly(f.rows, row, first);
        side_rows_add_slowly(f.rows, row, second);
        return;
    }
    *side_row_place(f.storeys, f.row_count, row, count) = first;
    *side_row_place(f.storeys, f.row_count, row, count + 1) = second;
    f.counts[row] = (uint8_t)(count + 2);
}

static inline void filling_prefetch(struct filling f, int32_t row)
{
    __builtin_prefetch(f.counts + row, 1);
    __builtin_prefetch(f.storeys + row, 1);
}

/* A triangle turned so that it begins with its smallest corner, a. */
struct turned {
    int32_t a, b, c;
    uint64_t ab, ac, bc; /* the places of its sides: two in the row of a, one in that of b or c */
};

static inline struct turned turn_triangle(const int32_t t[3], uint32_t side)
{
    static const uint8_t after[4] = {1, 2, 0, 1};
    unsigned p = t[1] < t[0];
    p = t[2] < t[p] ? 2 : p;
    unsigned q = after[p], r = after[p + 1];
    int32_t a = t[p], b = t[q], c = t[r];
    uint32_t backward = b < c ? 0 : SIDE_BACKWARD;
    return (struct turned){a,
                           b,
                           c,
                           side_place(b, side + p),
                           side_place(c, (side + r) | SIDE_BACKWARD),
                           side_place(b < c ? c : b, (side + q) | backward)};
}

static inline void filling_add_triangle(struct filling f, const int32_t t[3], uint32_t side)
{
    struct turned k = turn_triangle(t, side);
    filling_add_two(f, k.a, k.ab, k.ac);
    filling_add_one(f, k.b < k.c ? k.b : k.c, k.bc);
}

/* Adds the triangles from the given one on. */
void side_rows_fill_from(struct filling f, const struct mesh *mesh, uint32_t first);

#endif
