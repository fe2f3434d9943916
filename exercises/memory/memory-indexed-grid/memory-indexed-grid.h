/* Problem 4.2: memory used by a grid as an indexed mesh.
 *
 * The grid has m rows of n cells and every cell is cut into two triangles. As an indexed mesh it is
 * two tables: the vertices (three float each) and the triangles (three int32_t each: indices into
 * the table of vertices, the first vertex is number 0).
 *
 * Sizes: a float and an int32_t take 4 bytes, 1 KB is 1024 bytes. Only the two tables count.
 *
 * You write the four functions. The file needs nothing but this header and the C library. */
#ifndef MEMORY_INDEXED_GRID_H
#define MEMORY_INDEXED_GRID_H

#include <stdint.h>

/* What a builder returns when malloc gave NULL. */
enum { OUT_OF_MEMORY = -1 };

struct indexed_grid {
    float *vertices;    /* x y z of vertex 0, x y z of vertex 1, ... */
    int32_t *triangles; /* three indices of triangle 0, three of triangle 1, ... */
    int32_t vertex_count;
    int32_t triangle_count;
};

/* Bytes of both tables together, for m rows of n cells.
 *
 * m, n     1 ... 100 000 000
 * returns  the exact number: mind that it does not always fit into 32 bits */
int64_t indexed_grid_bytes(int32_t m, int32_t n);

/* The same in KB for m = n = 128. Two decimals are enough. */
double indexed_grid_kilobytes(void);

/* How many faces there are for each vertex, F / V, when m and n are both very large (1/m and 1/n
 * are practically 0). */
double indexed_grid_faces_per_vertex(void);

/* Builds the grid over the unit square of the plane z = 0.
 *
 * The vertices lie at x = column / n and y = row / m, for column 0 ... n and row 0 ... m, within
 * 0.00001, each once and z = 0. Every cell is cut by one of its diagonals (either) and its two
 * triangles are counter-clockwise seen from above, from positive z. The vertices may be numbered,
 * and the triangles listed, in any order.
 *
 * m, n     1 or more; the tables are never larger than 100 MB
 * grid     comes in with unknown contents; fill all four fields. Each table is one block of exactly
 * its size, from malloc; the caller frees both with free returns  0, or OUT_OF_MEMORY; then nothing
 * stays allocated and the fields do not matter
 *
 * The time must be linear in the number of vertices. */
int indexed_grid_build(int32_t m, int32_t n, struct indexed_grid *grid);

#endif
