/* Triangle strips that a builder made of a grid, one for each row of cells (problem 4.3). They are
 * decoded triangle by triangle and judged by where their vertices lie, so that strips may stand in
 * any order, run either way and cut cells by either diagonal.
 *
 * Vertices i, i + 1, i + 2 of a strip are its triangle i; of odd ones the first two change places.
 */
#ifndef GRADERS_LIBRARY_BUILT_STRIPS_H
#define GRADERS_LIBRARY_BUILT_STRIPS_H

#include "graders/library/lattice.h"

/* Strips that are all there, in place. */
struct built_strips {
    int64_t strip_count, vertices_per_strip;
    const float **strips; /* owned */
};

int64_t built_strips_vertices(int64_t m, int64_t n); /* of all strips together */

/* Reads vertices_per_strip, strip_count and the strips of a grid of asked[0] rows of asked[1]
 * cells. Rejects wrong counts, and strips that are not there. Returns 0, or -1 and *err (out of
 * memory). Without a rejection the caller ends with built_strips_release. */
int built_strips_read(struct reader *said, const int64_t asked[2], struct built_strips *built,
                      struct judgement *out, struct error *err) MUST_CHECK;
void built_strips_release(struct built_strips *built);

/* What of the strips is looked at. */
enum { BUILT_COVER = 1, BUILT_WINDING = 2 };

/* Judges strips. Asked: m, n and what is looked at. COVER: every vertex is at a lattice point.
 * Always: triangles are halves of cells, none twice, all of a strip in one row. WINDING: they are
 * counter-clockwise. Accepts, or rejects, names the first fault, marks all and shows the strips.
 * Returns 0, or -1 and *err (out of memory). */
int built_strips_judge(const int64_t asked[3], const struct built_strips *built,
                       struct judgement *out, struct error *err) MUST_CHECK;

#endif
