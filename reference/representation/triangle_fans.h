/* Triangle fans (fan di triangoli) of positions: all triangles of a fan share its first vertex;
 * each further vertex makes one more triangle.
 *
 *        3-----2             fan 0: 0 1 2 3 4 5, triangles
 *       / \   / \                (0,1,2)  (0,2,3)  (0,3,4)  (0,4,5)
 *      /   \ /   \           around a closed vertex the last entry is the first of the ring again
 *     4-----0-----1
 *      \   /
 *       \ /
 *        5
 *
 * Numbers, invariants, links and costs are those of triangle strips (triangle_strips.h); but the
 * triangles around a vertex are few, so fans are short: a whole ring of 6 takes 8 entries, and what
 * is left between rings takes 3 or 4 for one or two triangles. Document 004: fans are efficient,
 * strips less, but strips hold more triangles.
 *
 * Built greedily: from the first triangle left, around whichever of its corners the fan gets
 * largest. Rings that tile the mesh would take 4/3 entries a triangle; greedily 1.34 (torus)
 * to 1.71 (icosphere) were measured, strips take 1.00 to 1.12 there.
 *
 * Bytes: 4 + 4 a fan (where it starts) + 12 an entry. */
#ifndef REFERENCE_REPRESENTATION_TRIANGLE_FANS_H
#define REFERENCE_REPRESENTATION_TRIANGLE_FANS_H

#include "reference/mesh/strips.h"
#include "reference/representation/representation.h"

/* Stored as strips are, read as fans: positions, and where each fan starts. */
struct triangle_fans {
    struct strips entries;
};

extern const struct representation representation_triangle_fans;

#endif
