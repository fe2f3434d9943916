/* Judging queries for neighbours on a closed mesh: what touches a face, a vertex, an edge.
 *
 *     struct winged_edge_mesh we;
 *     if (neighbours_build(&task->polygons, &we, err))
 *         return -1;
 *     const struct neighbour_asked asked = {&task->polygons, &we, EDGES_OF_FACE, 3, capacity,
 *                                           returned, listed, listed_count};
 *     if (neighbours_judge(&asked, out, err))
 *         return -1;
 *     return out->cause[0] ? task_show(task, out, err) : ...;
 *
 * What is right the library's own queries say, on the same table (winged_edge_queries.h). Around a
 * face the order counts, counter-clockwise from anywhere; else any order will do. */
#ifndef GRADERS_LIBRARY_NEIGHBOURS_H
#define GRADERS_LIBRARY_NEIGHBOURS_H

#include "graders/library/judgement.h"
#include "graders/library/polygons.h"
#include "reference/representation/winged_edge.h"

enum neighbour_kind {
    EDGES_OF_FACE,
    VERTICES_OF_FACE,
    FACES_OF_FACE, /* an entry for each edge of the face */
    EDGES_OF_VERTEX,
    FACES_OF_VERTEX,
    VERTICES_OF_VERTEX,
    EDGES_OF_EDGE, /* at either end, without the edge itself */
    NEIGHBOUR_KINDS
};

enum neighbour_element { AT_FACE, AT_VERTEX, AT_EDGE };

/* What a query is. */
struct neighbour_query {
    const char *function; /* "edges_of_face" */
    enum neighbour_element of, finds;
    int shows; /* how many of what it finds one access of winged edges shows at most: a row names
                  four other edges, two faces, two vertices */
    int32_t (*right)(const struct winged_edge_mesh *we, int32_t element, int32_t *out,
                     int32_t capacity);
};
extern const struct neighbour_query neighbour_queries[NEIGHBOUR_KINDS];

/* A query and what was answered; the numbers may be anything. */
struct neighbour_asked {
    const struct polygon_view *faces;
    const struct winged_edge_mesh *we; /* of these faces */
    enum neighbour_kind kind;
    int32_t element;
    int32_t capacity, returned; /* room for the answer; the count that was returned */
    const int32_t *listed;      /* what was written, as far as it was returned and fits */
    int32_t listed_count;
};

/* Builds the winged edges of a closed mesh; the caller releases them (winged_edge_release). Returns 0,
 * or -1 and *err. */
int neighbours_build(const struct polygon_view *faces, struct winged_edge_mesh *we,
                     struct error *err) MUST_CHECK;

/* Rejects a wrong answer: says which number is wrong, names the element that was asked for, marks
 * both. Leaves `out` alone when it is right. Returns 0, or -1 and *err. O(n log n) in what is
 * listed. */
int neighbours_judge(const struct neighbour_asked *asked, struct judgement *out,
                     struct error *err) MUST_CHECK;

/* Shows a query that was answered rightly, where something else is wrong with the answers: the
 * element and what is listed for it. */
void neighbours_show(const struct neighbour_asked *asked, struct scene *scene);

/* How many there are, and the accesses without which no program can find them. */
int32_t neighbours_count(const struct winged_edge_mesh *we, int kind, int32_t element);
int64_t neighbours_least_accesses(const struct winged_edge_mesh *we, int kind, int32_t element);

#endif
