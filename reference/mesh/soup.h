/* Isolated triangles, the first representation of the course: nine floats each, nothing shared.
 *
 * Bytes: 36 a triangle (three vertices of three binary32). */
#ifndef REFERENCE_MESH_SOUP_H
#define REFERENCE_MESH_SOUP_H

#include "reference/mesh/mesh.h"

struct soup {
    float *corners; /* 9 * triangle_count: x y z of triangle 0's first corner, second, third, ... */
    int32_t triangle_count;
};

/* Makes a soup with room for triangle_count (0 ... INT32_MAX / 9) triangles, all zero; the caller
 * owns it (soup_release). Returns 0, or -1 and *err. */
int soup_init(struct soup *soup, int64_t triangle_count, struct error *err) MUST_CHECK;
void soup_release(struct soup *soup);

/* Checks that every coordinate is finite. Returns 0, or -1 and *err naming the triangle. */
int soup_check(const struct soup *soup, struct error *err) MUST_CHECK;

/* Bytes that the triangles of a soup take. */
int64_t soup_bytes(int64_t triangle_count);

/* The triangles of a valid mesh, one by one, in order. The caller owns the soup.
 * Returns 0, or -1 and *err. */
int soup_from_mesh(struct soup *soup, const struct mesh *mesh, struct error *err) MUST_CHECK;

/* Welds a valid soup: corners with equal coordinates (0 and -0 are equal) become one vertex,
 * numbered by first appearance; triangles stay in order with their winding. The caller owns the
 * mesh.
 *
 * returns  0, or -1 and *err
 * cost     expected linear, by hashing the coordinates */
int soup_to_mesh(struct mesh *mesh, const struct soup *soup, struct error *err) MUST_CHECK;

#endif
