/* Cells of four corners that are cut into two triangles by either diagonal: whether a triangle of
 * an answer is half of a cell, and what is said of one that is not. lattice.h and sphere.h lay the
 * cells out. */
#ifndef GRADERS_LIBRARY_CELLS_H
#define GRADERS_LIBRARY_CELLS_H

#include "graders/library/built.h"

/* How a triangle fits, after it was added. Only CELL_HALF and CELL_HALF_FLIPPED cover anything. */
enum cell_fit {
    CELL_HALF,         /* half a cell, counter-clockwise */
    CELL_HALF_FLIPPED, /* half a cell, clockwise */
    CELL_REPEATED,     /* this half was covered before */
    CELL_CROSSED,      /* it overlaps a half that was cut by the other diagonal */
    CELL_OUTSIDE       /* not half a cell: its corners are not three corners of one cell */
};

/* Adds a triangle to the cell that holds its corner with the smallest x and y.
 *
 * halves   the cell: bit 0 ... 3, the half without that corner is covered; 0 at first
 * x, y     of the three corners, counted from the cell's first one; outside 0 ... 1 is allowed.
 *          Counter-clockwise is from x to y */
enum cell_fit cell_add(uint8_t *halves, const int32_t x[3], const int32_t y[3]);

/* Whether both halves are covered. */
bool cell_is_covered(uint8_t halves);

/* How a triangle that does not fit is marked. */
enum mark_kind cell_mark(enum cell_fit fit);

/* What the triangles of a mesh must cover. */
struct cell_cover {
    void *cells;
    /* adds a triangle, whose corners are vertices of the mesh */
    enum cell_fit (*add)(void *cells, const int32_t corner[3]);
    struct phrase seen_from; /* where counter-clockwise is seen from: {"above", "arriba"} */
    struct phrase hint;      /* what half of a cell is, when it must be said */
};

/* Rejects a triangle that does not fit (fit is not CELL_HALF).
 *
 * subject   begins the sentence: "Triangle 3 (4, 9, 5)" */
void cell_reject(enum cell_fit fit, const struct message *subject, const struct cell_cover *cover,
                 struct judgement *out);

/* Adds every triangle of a mesh, whose vertices and triangles are there. The first that does not
 * fit is named and rejected, all such are marked; an index out of range ends it. */
void cells_judge(const struct built_mesh *mesh, const struct cell_cover *cover,
                 struct judgement *out);

#endif
