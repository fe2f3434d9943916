/* Plain loops over positions and triangles that several representations share. Positions are three
 * floats a vertex; `corners` are three vertex numbers a triangle. Nothing is allocated. */
#ifndef REFERENCE_REPRESENTATION_TRIANGLE_SWEEPS_H
#define REFERENCE_REPRESENTATION_TRIANGLE_SWEEPS_H

#include "reference/base/error.h"

#include <stdbool.h>
#include <stdint.h>

/* Checks that every coordinate of `count` positions is finite. Returns 0, or -1 and *err naming the
 * vertex. */
int positions_check(const float *positions, int64_t count, struct error *err) MUST_CHECK;

/* p becomes A p + b; matrix holds the rows (A | b). Returns `count`. */
int64_t positions_transform(float *positions, int64_t count, const float matrix[12]);

/* Whether two positions are equal; 0 and -0 are. */
static inline bool same_position(const float *p, const float *q)
{
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/* Sum of the areas, added in double. */
double triangles_area(const float *positions, const int32_t *corners, int64_t count);

/* Unit normal of each triangle; zero where it has no area. normals: 3 * count floats. */
void triangles_normals(const float *positions, const int32_t *corners, int64_t count,
                       float *normals);

/* Adds each triangle's area vector (twice its area long) to its three vertices' normals. */
void triangles_add_normals(const float *positions, const int32_t *corners, int64_t count,
                           float *vertex_normals);

/* Makes each of `count` vectors one long; zero stays zero. */
void vectors_to_unit(float *vectors, int64_t count);

#endif
