/* Corner table (Rossignac, Safonova, Szymczak 2001): two integers for each corner of each triangle,
 * the vertex and the opposite corner. Beside the course, as the leanest of the linked structures.
 *
 *                    v                       here          in the paper
 *                  / c \                     vertex[c]     V[c], c.v
 *                /       \                   opposite[c]   O[c], c.o
 *              /           \                 c / 3         c.t, triangle of the corner
 *            /  t           \                next(c)       c.n, counter-clockwise in the triangle
 *          / n             p \               previous(c)   c.p
 *        ----------------------- edge        swing(c)      the corner at v in the triangle across
 *          \               /                               the side p -> c
 *            \           /
 *              \   o   /                     Corners 3t, 3t + 1, 3t + 2 are those of triangle t, so
 *                \   /                       c / 3, next and previous are arithmetic.
 *                                            o = opposite(c) faces the same edge, from beyond it.
 *
 * Triangles only. Where there is no triangle on the other side, opposite is -1.
 *
 * Invariants (corner_table_check):
 *  - vertex is in range and the three of a triangle differ;
 *  - opposite(opposite(c)) = c, and both see the edge the other way: vertex(next(c)) is
 *    vertex(previous(o)) and the other way round;
 *  - vertex_corner(v) is at v (-1: isolated); on a boundary it is the one whose previous corner has
 *    no opposite, so that swinging from it meets every corner of v: one fan (manifold).
 *
 * It refuses degenerate triangles, edges with more than two triangles, edges that two triangles run
 * through in the same direction, and vertices whose triangles are not one fan. It holds isolated
 * vertices.
 *
 * Bytes: 24 a triangle, 16 a vertex (12 of them its position, 4 vertex_corner, which the paper
 * leaves out); a large closed mesh takes 32 a triangle. Accesses, for a vertex of k triangles:
 * next, previous, triangle none; corners or neighbours of a triangle 1, three entries side by side;
 * around a vertex, is it an edge: k. All edges once: a sweep over the corners. */
#ifndef REFERENCE_REPRESENTATION_CORNER_TABLE_H
#define REFERENCE_REPRESENTATION_CORNER_TABLE_H

#include "reference/mesh/mesh.h"

#include <stdbool.h>
#include <stdint.h>

struct corner_table {
    float *positions;       /* 3 a vertex */
    int32_t *vertex_corner; /* one corner at each vertex; -1: isolated */
    int32_t *vertex;        /* V: 3 a triangle */
    int32_t *opposite;      /* O: 3 a triangle; -1: none */
    int32_t vertex_count;
    int32_t triangle_count;
};

/* Builds from a valid mesh; corners are those of its triangles.
 *
 * table    its old contents are not looked at; on success the caller owns it
 * returns  0, or -1 and *err naming what it refuses (above), or out of memory; then *table is empty
 * cost     linear */
int corner_table_build(struct corner_table *table, const struct mesh *mesh,
                       struct error *err) MUST_CHECK;

/* Frees the tables and leaves the empty mesh; a zeroed one may be released. */
void corner_table_release(struct corner_table *table);

/* Checks the invariants. Returns 0, or -1 and *err naming the element at fault. Linear. */
int corner_table_check(const struct corner_table *table, struct error *err) MUST_CHECK;

/* The indexed mesh, exactly as it was; the caller owns it. Returns 0, or -1 and *err. */
int corner_table_to_mesh(const struct corner_table *table, struct mesh *mesh,
                         struct error *err) MUST_CHECK;

/* -- steps ----------------------------------------------------------------------------------- */

static inline int32_t corner_next(int32_t corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

static inline int32_t corner_previous(int32_t corner)
{
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}

/* The corner at the same vertex in the next triangle counter-clockwise, or -1. One access. */
static inline int32_t corner_table_swing(const struct corner_table *table, int32_t corner)
{
    int32_t opposite = table->opposite[corner_next(corner)];
    return opposite < 0 ? -1 : corner_next(opposite);
}

/* The triangle across the side from this corner to the next, or -1. One access. */
static inline int32_t corner_table_across(const struct corner_table *table, int32_t corner)
{
    int32_t opposite = table->opposite[corner_previous(corner)];
    return opposite < 0 ? -1 : opposite / 3;
}

/* Whether a vertex is an end of a boundary edge. */
static inline bool corner_table_on_boundary(const struct corner_table *table, int32_t vertex)
{
    int32_t corner = table->vertex_corner[vertex];
    return corner >= 0 && table->opposite[corner_previous(corner)] < 0;
}

#endif
