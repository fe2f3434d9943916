/* What a builder of tables returns: a status, counts and tables in the caller's struct, and what
 * the student's own formula says of their size. All of it is read from an answer that may hold
 * anything.
 *
 *     static const struct built_count vertex_count = {
 *         .field = "vertex_count",
 *         .cause = {"vertex-count", {"number of vertices", "número de vértices"}},
 *         .right = grid_vertices,
 *         .rule = {"A row of n cells has n + 1 vertices.", "..."}};
 *
 *     struct built_mesh built;
 *     if (!built_mesh_read(said, &built, out) ||
 *         !built_count_is_right(&vertex_count, asked, built.vertex_count, out) ||
 *         !built_has_table("vertices", built.vertices, out))
 *         return built_mesh_show(&built, &out->scene, err);
 *
 * What is asked of a builder (question.h) begins with the one or two numbers that sizes depend on.
 */
#ifndef GRADERS_LIBRARY_BUILT_H
#define GRADERS_LIBRARY_BUILT_H

#include "graders/library/formula.h"

/* A count that a builder fills in. */
struct built_count {
    const char *field;  /* "vertex_count" */
    struct cause cause; /* when it is wrong in no usual way */
    int64_t (*right)(int64_t a, int64_t b);
    struct phrase rule;                     /* the hint then */
    const struct formula_mistake *mistakes; /* usual ones; may be NULL */
};

/* Rejects a count that is not the right one for what was asked. Returns whether it is right. */
bool built_count_is_right(const struct built_count *count, const int64_t asked[2], int64_t said,
                          struct judgement *out);

/* Rejects a table that is NULL, or was left out for want of room. Returns whether it is there. */
bool built_has_table(const char *field, const void *table, struct judgement *out);

/* Reads the status that begins an answer, and rejects one that is not 0. Returns whether it is 0.
 */
bool built_status(struct reader *said, struct judgement *out);

/* Rejects an answer that ended too early. Returns whether all that was read was there. */
bool built_is_complete(const struct reader *said, struct judgement *out);

/* An indexed mesh that was built, in place. Counts may be anything; what a table that is not NULL
 * holds is as long as its count says. */
struct built_mesh {
    const float *vertices;
    const int32_t *triangles;
    int64_t vertex_count, triangle_count;
    int64_t own_bytes; /* what the student's formula says */
};

/* Reads the answer: status, vertices, triangles, own_bytes. Returns whether it is there; otherwise
 * the mesh is empty and the answer rejected. */
bool built_mesh_read(struct reader *said, struct built_mesh *mesh, struct judgement *out);

/* Shows what there is of it. Returns 0, or -1 and *err (out of memory). */
int built_mesh_show(const struct built_mesh *mesh, struct scene *scene,
                    struct error *err) MUST_CHECK;

/* Bytes that an answer can take: room for twice the right structure, in as many tables. */
size_t built_bound(int64_t right_bytes, int64_t table_count);

#endif
