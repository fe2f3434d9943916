/* The grid of problems 4.2 and 4.3 as a judge sees it: m rows of n cells on the unit square, every
 * cell cut into two triangles by either diagonal. Vertices are told apart by where they lie, so a
 * student may number vertices and order triangles in any way. Cells are looked at one by one:
 * surface.h compares with one right mesh, and here either diagonal is right.
 *
 * Point r * (n + 1) + c of the lattice lies at x = c / n, y = r / m, z = 0. */
#ifndef GRADERS_LIBRARY_LATTICE_H
#define GRADERS_LIBRARY_LATTICE_H

#include "graders/library/cells.h"
#include "graders/library/questions.h"

/* How many rows and columns formulas of grids are asked for. */
extern const struct question_rows lattice_few;   /* the course's figure */
extern const struct question_rows lattice_many;  /* values of 32 bits */
extern const struct question_rows lattice_large; /* values above, up to 100 000 000 a side */

/* Counts of a grid that was built as an indexed mesh. */
extern const struct built_count lattice_vertex_count, lattice_triangle_count;

/* What a grid of m rows of n cells has, and the bytes of it as an indexed mesh. */
int64_t lattice_vertices(int64_t m, int64_t n);
int64_t lattice_triangles(int64_t m, int64_t n);
int64_t lattice_mesh_bytes(int64_t m, int64_t n);

/* Sizes: grids of exactly so many vertices, square (or nearly), of one row and of one column. */
extern const struct size_family lattice_families[];

/* The size near `vertex_count` of which there is a grid: as square as can be, or of one row. */
int64_t lattice_size_near(int family, int64_t vertex_count);

/* Asks a builder for the grid of a size of one of these families: its numbers are m, n and `looks`.
 * There is one grid of each size and shape. Returns 0, or -1 and *err (no such grid). */
int lattice_make_sized(const struct question *build, int64_t looks, int family,
                       int64_t vertex_count, struct writer *input, struct error *err) MUST_CHECK;

struct lattice {
    int32_t m, n;
    uint8_t *halves; /* of m * n cells (cells.h) */
};

/* m, n >= 1 and m * n <= INT32_MAX. Returns 0, or -1 and *err. Ends with lattice_release. */
int lattice_init(struct lattice *lattice, int32_t m, int32_t n, struct error *err) MUST_CHECK;
void lattice_release(struct lattice *lattice);

/* The lattice point next to a position, -1 when there is none within a quarter of a cell. z is not
 * looked at. */
int32_t lattice_nearest(const struct lattice *lattice, const float position[3]);

/* The lattice point of a position that is within 0.00001 of it in each coordinate, else -1. */
int32_t lattice_point_at(const struct lattice *lattice, const float position[3]);

/* Rejects a position that is at no lattice point. subject begins the sentence: "Vertex 3". */
void lattice_reject_place(const struct lattice *lattice, const struct message *subject,
                          const float position[3], struct judgement *out);

/* Adds a triangle of three lattice points (-1 is allowed: CELL_OUTSIDE). *cell gets the number r *
 * n + c of its cell, -1 when it has none. */
enum cell_fit lattice_add(struct lattice *lattice, const int32_t point[3], int32_t *cell);

/* Rejects, when some cell is not covered by two halves, and names the first. */
void lattice_judge_cover(const struct lattice *lattice, struct judgement *out);

/* What of a grid is looked at. */
enum { LATTICE_VERTICES = 1, LATTICE_TRIANGLES = 2 };

/* Judges a grid that was built as an indexed mesh, with the right counts and both tables. Asked: m,
 * n and what is looked at. Vertices: every lattice point has exactly one. Triangles: they cover
 * every cell once, counter-clockwise seen from above (vertices are taken for the point next to
 * them). Accepts, or rejects, names the first element at fault, marks all and shows the mesh.
 * Returns 0, or -1 and *err (out of memory). */
int lattice_judge_mesh(const int64_t asked[3], const struct built_mesh *mesh, struct judgement *out,
                       struct error *err) MUST_CHECK;

#endif
