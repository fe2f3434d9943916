/* The distance of two surfaces: how far points of each are from the other, with exact distances of
 * points and triangles.
 *
 *     struct surface_distance d;
 *     if (surface_distance_find(&answer, &right, &d, err))
 *         return -1;
 *     if (!(d.hausdorff <= 4 * allowed))
 *         ... d.from_answer.point is the farthest point of the answer ...
 *
 * Points are taken at the corners of the triangles and at SURFACE_SAMPLES fixed places inside each,
 * the same always. */
#ifndef GRADERS_LIBRARY_DISTANCE_H
#define GRADERS_LIBRARY_DISTANCE_H

#include "graders/library/surface.h"

enum { SURFACE_SAMPLES = 10 };

/* The distance of a point and a triangle, which may be degenerate; `nearest` (may be NULL) becomes
 * the point of the triangle that is nearest. Source: Ericson, Real-Time Collision Detection (2005),
 * 5.1.5. */
double distance_point_triangle(const double p[3], const double a[3], const double b[3],
                               const double c[3], double nearest[3]);

/* Triangles, to be searched for the one nearest to a point. */
struct triangle_tree {
    const struct surface_mesh *mesh; /* borrowed */
    int32_t *order;                  /* triangles that can be searched, near ones together */
    int32_t count;
    double *boxes; /* 6 a node: lowest, highest corner; node i has children 2i + 1 and 2i + 2 */
    int64_t bad_corner, bad_corner_count; /* corners that name no vertex, or one that is not finite:
                                             their triangles are left out */
};

/* Builds a tree of any triangles. low, high: a box around what matters; what lies far outside is
 * found too, only slower. Returns 0, or -1 and *err (out of memory, negative count). O(n log n). */
int triangle_tree_build(struct triangle_tree *tree, const struct surface_mesh *mesh,
                        const double low[3], const double high[3], struct error *err) MUST_CHECK;
void triangle_tree_release(struct triangle_tree *tree);

/* The distance of p, and the triangle that is nearest (-1 and infinity: the tree is empty, or p is
 * not finite). Stops as soon as a triangle within `enough` is found: then the result is only known
 * to be that near; 0 asks for the exact one.
 *
 * triangle   before: the triangle to look at first, as the one that was nearest to a point beside;
 *            -1: none. It must be in tree->order */
double triangle_tree_distance(const struct triangle_tree *tree, const double p[3], double enough,
                              int32_t *triangle);

/* The farthest point of one surface from the other. */
struct surface_farthest {
    double distance; /* infinity: the other has no triangle, or a point is not finite */
    double point[3];
    int32_t triangle; /* that it is taken from; -1: the surface has none */
    int32_t nearest;  /* triangle of the other surface */
};

struct surface_distance {
    double hausdorff; /* the larger of both; infinity when just one is empty; 0 when both are */
    struct surface_farthest from_answer, from_right;
    int64_t bad_corner, bad_corner_count; /* of the answer, as above; with any hausdorff is infinity
                                           */
};

/* Finds it, to within 0.1 percent below: so long, a point that is nearer than the farthest so far
 * is not looked at further. Returns 0, or -1 and *err (out of memory, negative count). The right
 * surface must be finite with valid indices. */
int surface_distance_find(const struct surface_mesh *answer, const struct surface_mesh *right,
                          struct surface_distance *distance, struct error *err) MUST_CHECK;

#endif
