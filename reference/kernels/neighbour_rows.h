/* For each vertex the larger vertices that it meets in triangles: the work space of the edges-any
 * kernels.
 *
 * A row is a cache line of 16 places and takes every neighbour that comes, repeated or not: inside
 * a manifold each comes twice, so that rows are seldom full before valence 9. Only a full row drops
 * what is repeated. A vertex that then still has 16 gets the rest into one list for all, the
 * overflow, which is sorted by vertex at the end. So nothing is searched while rows are filled, and
 * no row needs clearing, only its count, a byte.
 *
 * Rejected: rows of 8 places, slower wherever the numbering is not that of a grid (15 against 5 ns
 * a triangle with 100,000 scrambled ones), as half of the vertices then fill theirs; searching
 * before adding, as the textbook does, which costs a chain of compare and store for each neighbour
 * (8 to 9 ns against 3). */
#ifndef REFERENCE_KERNELS_NEIGHBOUR_ROWS_H
#define REFERENCE_KERNELS_NEIGHBOUR_ROWS_H

#include "reference/mesh/mesh.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum {
    ROW_PLACES = 16,
    ROW_OVERFLOWS = 17, /* as a count: 16 different neighbours here, more in the overflow */
};

struct neighbour_rows {
    uint8_t *counts;   /* one for each vertex */
    int32_t *places;   /* ROW_PLACES for each vertex, 64-byte aligned */
    int32_t *overflow; /* pairs (vertex, neighbour) in the order of coming */
    int64_t overflow_count;
    int32_t *sorted_end; /* once sorted: where the neighbours of a vertex end in sorted */
    int32_t *sorted;     /* the neighbours in the overflow, by vertex */
    int32_t *met_by;     /* for each vertex of the mesh, the last row that listed it */
    bool met_by_is_clear;
    int32_t first_vertex; /* rows are those of first_vertex and the row_count - 1 after it */
    int32_t row_count;
    int32_t vertex_count; /* of the mesh */
};

static inline uint8_t *neighbour_row_count(const struct neighbour_rows *rows, int32_t vertex)
{
    return rows->counts + (vertex - rows->first_vertex);
}

static inline int32_t *neighbour_row(const struct neighbour_rows *rows, int32_t vertex)
{
    return rows->places + ROW_PLACES * (size_t)(vertex - rows->first_vertex);
}

/* Bytes of scratch; of these only 65 a vertex are touched when no row overflows. */
size_t neighbour_rows_bytes(int64_t vertex_count, int64_t triangle_count);

/* Lays empty rows for all vertices out in scratch. */
struct neighbour_rows neighbour_rows_begin(void *scratch, const struct mesh *mesh);

/* Makes them the empty rows of some vertices only. */
void neighbour_rows_restart(struct neighbour_rows *rows, int32_t first_vertex, int32_t row_count);

/* Adds one neighbour, the slow way that copes with full rows. */
void neighbour_rows_add_to_full(struct neighbour_rows *rows, int32_t vertex, int32_t neighbour);

static inline void neighbour_rows_add_two(struct neighbour_rows *rows, int32_t vertex,
                                          int32_t first, int32_t second)
{
    uint8_t *count = neighbour_row_count(rows, vertex);
    if (__builtin_expect(*count > ROW_PLACES - 2, 0)) {
        neighbour_rows_add_to_full(rows, vertex, first);
        neighbour_rows_add_to_full(rows, vertex, second);
        return;
    }
    const int32_t both[2] = {first, second};
    memcpy(neighbour_row(rows, vertex) + *count, both, sizeof both);
    *count = (uint8_t)(*count + 2);
}

static inline void neighbour_rows_add_one(struct neighbour_rows *rows, int32_t vertex,
                                          int32_t neighbour)
{
    uint8_t *count = neighbour_row_count(rows, vertex);
    if (__builtin_expect(*count > ROW_PLACES - 1, 0)) {
        neighbour_rows_add_to_full(rows, vertex, neighbour);
        return;
    }
    neighbour_row(rows, vertex)[*count] = neighbour;
    *count = (uint8_t)(*count + 1);
}

/* Adds a triangle with corners low <= middle <= high. */
static inline void neighbour_rows_add(struct neighbour_rows *rows, int32_t low, int32_t middle,
                                      int32_t high)
{
    neighbour_rows_add_two(rows, low, middle, high);
    neighbour_rows_add_one(rows, middle, high);
}

static inline void neighbour_rows_prefetch(const struct neighbour_rows *rows, int32_t vertex)
{
    __builtin_prefetch(neighbour_row_count(rows, vertex), 1);
    __builtin_prefetch(neighbour_row(rows, vertex), 1);
}

/* Sorts the overflow by vertex; call it once all triangles are added. */
void neighbour_rows_sort_overflow(struct neighbour_rows *rows);

/* Writes the edges (vertex, neighbour) of the rows begin ... end - 1, each once, by vertex and then
 * in the order of coming. Returns the end of what it wrote; a row further may be overwritten. */
int32_t *neighbour_rows_put_edges(const struct neighbour_rows *rows, int32_t begin, int32_t end,
                                  int32_t *edges);
#if defined(__x86_64__)
int32_t *neighbour_rows_put_edges_avx2(const struct neighbour_rows *rows, int32_t begin,
                                       int32_t end, int32_t *edges);
int32_t *neighbour_rows_put_edges_avx512(const struct neighbour_rows *rows, int32_t begin,
                                         int32_t end, int32_t *edges);
#endif

/* The same for one row whose count says that it overflows. */
int32_t *neighbour_rows_put_overflow(const struct neighbour_rows *rows, int32_t vertex,
                                     int32_t *edges);

#endif
