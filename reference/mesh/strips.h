/* Triangle strips, the second representation of the course: each strip is a sequence of positions
 * in which every three successive ones make a triangle. Triangle i of a strip is (i, i+1, i+2), and
 * the odd ones are wound the other way: (i+1, i, i+2). n triangles take n + 2 positions.
 *
 * Bytes, as the course counts them: a table with one int (how many strips) and a pointer of 8 bytes
 * a strip, and 12 bytes a vertex of every strip. */
#ifndef REFERENCE_MESH_STRIPS_H
#define REFERENCE_MESH_STRIPS_H

#include "reference/mesh/mesh.h"
#include "reference/mesh/soup.h"

struct strips {
    float *positions;      /* 3 * vertex_count: all strips, one after another */
    int32_t *first_vertex; /* strip s has vertices first_vertex[s] ... first_vertex[s + 1] - 1;
                              strip_count + 1 entries, NULL when there is no strip */
    int32_t vertex_count;
    int32_t strip_count;
};

/* Makes strips of the given lengths with all positions zero; the caller owns them (strips_release).
 *
 * vertex_counts  strip_count lengths of at least 3; NULL allowed when strip_count is 0
 * returns        0, or -1 and *err */
int strips_init(struct strips *strips, int64_t strip_count, const int32_t *vertex_counts,
                struct error *err) MUST_CHECK;
void strips_release(struct strips *strips);

/* Checks that strips follow each other without gap, have at least 3 vertices each, and that every
 * coordinate is finite. Returns 0, or -1 and *err naming the strip. */
int strips_check(const struct strips *strips, struct error *err) MUST_CHECK;

/* Triangles in all strips. */
int64_t strips_triangle_count(const struct strips *strips);

/* Bytes of strips with vertex_count vertices in all: 4 + 8 strip_count + 12 vertex_count. */
int64_t strips_bytes(int64_t strip_count, int64_t vertex_count);

/* The triangles of valid strips, one by one, with their winding. The caller owns the soup.
 * Returns 0, or -1 and *err. */
int strips_to_soup(struct soup *soup, const struct strips *strips, struct error *err) MUST_CHECK;

/* The same, welded (soup_to_mesh). The caller owns the mesh. Returns 0, or -1 and *err. */
int strips_to_mesh(struct mesh *mesh, const struct strips *strips, struct error *err) MUST_CHECK;

/* Cuts a valid mesh into strips: every triangle once, with its winding. Each strip starts at the
 * first triangle left, along whichever of its sides leads farthest, in that direction only: short
 * code and decent strips, not the fewest. The caller owns the strips.
 *
 * returns  0, or -1 and *err
 * cost     linear */
int strips_from_mesh(struct strips *strips, const struct mesh *mesh, struct error *err) MUST_CHECK;

/* Strips of vertex numbers instead of positions, one after another. */
struct strip_numbers {
    int32_t *indices; /* index_count vertices */
    int32_t *lengths; /* strip_count lengths of at least 3 */
    int64_t index_count;
    int32_t strip_count;
};

/* The same cut as numbers; the caller owns them. Returns 0, or -1 and *err. */
int strip_numbers_from_mesh(struct strip_numbers *strips, const struct mesh *mesh,
                            struct error *err) MUST_CHECK;
void strip_numbers_release(struct strip_numbers *strips);

#endif
