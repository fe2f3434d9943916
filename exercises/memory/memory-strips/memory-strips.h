/* Problem 4.3: memory used by a grid as triangle strips, and vertices processed to draw it.
 *
 * The grid is that of problem 4.2: m rows of n cells, every cell cut into two triangles. Here every
 * row of 2n triangles is one strip, so there are m strips. A strip is a table of vertices (three
 * float each) in the order in which they are drawn: vertices i, i + 1, i + 2 are triangle i. Its
 * corners are read in the order i, i + 1, i + 2 when i is even and i + 1, i, i + 2 when i is odd.
 *
 * Sizes: a float and an int32_t take 4 bytes, a pointer takes 8, 1 KB is 1024 bytes. What counts:
 * the strips, and the table of strips, that is one int (how many there are) and a pointer to each.
 *
 * You write the seven functions. The file needs nothing but this header and the C library. */
#ifndef MEMORY_STRIPS_H
#define MEMORY_STRIPS_H

#include <stdint.h>

/* What a builder returns when malloc gave NULL. */
enum { OUT_OF_MEMORY = -1 };

struct strip_grid {
    float **strips;             /* a pointer to each strip; a strip is x y z, x y z, ... */
    int32_t strip_count;        /* the one int of the table: its 4 bytes count */
    int32_t vertices_per_strip; /* for whoever reads the strips; the problem does not count it */
};

/* Bytes of the table of strips and all the strips, for m rows of n cells.
 *
 * m, n     1 ... 100 000 000
 * returns  the exact number: mind that it does not always fit into 32 bits */
int64_t strips_bytes(int32_t m, int32_t n);

/* The same in KB for m = n = 128. Two decimals are enough. */
double strips_kilobytes(void);

/* Vertices that are processed (transformed, once each time that they stand in a table) to draw the
 * grid as strips, and as the indexed mesh of problem 4.2. m, n as above. */
int64_t strips_processed_vertices(int32_t m, int32_t n);
int64_t indexed_processed_vertices(int32_t m, int32_t n);

/* When m and n are both very large: bytes of the indexed mesh / bytes of the strips. */
double strips_memory_ratio(void);

/* When m and n are both very large: vertices processed for the strips / for the indexed mesh. */
double strips_time_ratio(void);

/* Builds the grid over the unit square of the plane z = 0 as m strips, one for each row of cells.
 *
 * The vertices lie at x = column / n, y = row / m, for column 0 ... n and row 0 ... m, within
 * 0.00001, and z = 0. All triangles, read as above, are counter-clockwise seen from above, from
 * positive z; none has zero area. The strips may stand in any order and run in either direction.
 *
 * m, n     1 or more; the strips are never larger than 100 MB together
 * grid     comes in with unknown contents; fill all three fields. The table of pointers is one
 * block and each strip is one block, each of exactly its size, from malloc; the caller frees every
 * strip and then the table, with free returns  0, or OUT_OF_MEMORY; then nothing stays allocated
 * and the fields do not matter
 *
 * The time must be linear in the number of vertices. */
int strips_build(int32_t m, int32_t n, struct strip_grid *grid);

#endif
