/* Whether triangles tile a polygon of the plane, exactly.
 *
 * Triangles tile it when each has a positive area and their directed sides cancel to the outline:
 * each side is run as often the one way as the other, but for the steps of the outline, which are
 * run once more. Then every point inside is covered once and no other. No search for overlaps is
 * needed, and holes, polygons beside each other and points inside are no special cases.
 *
 *     struct tiling_outline outline = {first, vertices, 1, first[1]};
 *     struct tiling_fault fault;
 *     if (tiling_check(points, point_count, &outline, triangles, triangle_count, &fault, err))
 *         return -1;
 *     const struct cause *cause = tiling_fault_cause(&fault);
 *     tiling_fault_release(&fault);
 */
#ifndef GRADERS_LIBRARY_TILING_H
#define GRADERS_LIBRARY_TILING_H

#include "graders/library/plane.h"
#include "reference/base/error.h"
#include "reference/base/phrase.h"

/* Closed chains of points, borrowed and ours: outer ones counter-clockwise, holes clockwise. Where
 * triangles may have corners on a side of the outline, these are points of the chain. */
struct tiling_outline {
    const int32_t *first; /* count + 1 offsets */
    const int32_t *vertices;
    int64_t count; /* chains */
};

enum tiling_mark { TILING_FINE, TILING_BAD_INDEX, TILING_NO_AREA, TILING_FLIPPED, TILING_LOOSE };

/* First element of each kind (-1: none), and how many. */
struct tiling_fault {
    int64_t bad_corner, bad_corner_count; /* corners that name no point */
    int64_t no_area, no_area_count;       /* triangles */
    int64_t flipped, flipped_count;       /* triangles that run clockwise */
    int64_t gap, gap_count;     /* steps of the outline, by the place of their first point in
                                   `vertices`, that no triangle runs */
    int64_t loose, loose_count; /* sides, by their corner, that no neighbour runs back and that are
                                   no step of the outline: triangles overlap there, or a part of the
                                   polygon is not covered, or lies outside */
    double area, right_area;    /* sums, in units of the points' coordinates */
    uint8_t *marks;             /* of each triangle: the first of its faults, enum tiling_mark */
};

extern const struct cause tiling_bad_index, tiling_no_area, tiling_flipped, tiling_gap,
    tiling_loose;

/* Checks.
 *
 * points      coordinates up to PLANE_COORDINATE_MOST
 * triangles   3 * triangle_count numbers, which may be anything
 * fault       on success the caller owns it (tiling_fault_release)
 * returns     0, or -1 and *err (out of memory, a negative count)
 * cost        O(n log n) */
int tiling_check(const struct plane_point *points, int32_t point_count,
                 const struct tiling_outline *outline, const int32_t *triangles,
                 int64_t triangle_count, struct tiling_fault *fault, struct error *err) MUST_CHECK;
void tiling_fault_release(struct tiling_fault *fault);

/* The cause to tell first: bad index, no area, flipped, gap, loose; NULL: it is a tiling. */
const struct cause *tiling_fault_cause(const struct tiling_fault *fault);

/* The first edge between two triangles of a tiling that is not Delaunay: the corner of a side whose
 * opposite point lies inside the circle of the side's triangle; -1: none. *inside becomes that
 * point. Edges that are given (the outline) do not count when they have one triangle. Returns 0, or
 * -1 and *err (out of memory). */
int tiling_find_not_delaunay(const struct plane_point *points, int32_t point_count,
                             const int32_t *triangles, int64_t triangle_count, int64_t *corner,
                             int32_t *inside, struct error *err) MUST_CHECK;

#endif
