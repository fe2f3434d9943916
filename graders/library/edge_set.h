/* The edges of a mesh, as a judge needs them: each once, with where it comes from, and how often an
 * answer lists it. */
#ifndef GRADERS_LIBRARY_EDGE_SET_H
#define GRADERS_LIBRARY_EDGE_SET_H

#include "graders/library/mesh_case.h"

/* How the triangles of an edge name it, or how the entries of an answer do. */
enum edge_flag {
    EDGE_UP = 1 << 0,              /* some triangle goes from the smaller to the larger number */
    EDGE_DOWN = 1 << 1,            /* some triangle goes the other way */
    EDGE_CLOSING_ONLY = 1 << 2,    /* it is only ever the side from a third corner to the first */
    EDGE_DEGENERATE_ONLY = 1 << 3, /* all of its triangles have a repeated vertex */
    EDGE_LISTED_UP = 1 << 4,
    EDGE_LISTED_DOWN = 1 << 5
};

struct listed_edge {
    int32_t low, high;    /* low < high */
    int32_t triangle;     /* the first triangle that joins them */
    int32_t side_count;   /* sides of triangles that are this edge; 1: a boundary edge */
    int64_t listed_count; /* entries of the answer that are this edge */
    uint32_t flags;
    int64_t first_entry; /* the first of these entries; -1: not listed */
};

/* Sorted by low, then by high. The zero value is an empty set. */
struct edge_set {
    struct listed_edge *edges;
    int64_t count;
    int64_t *row; /* edges of low vertex v: row[v] ... row[v + 1] - 1 */
};

/* Finds the edges of a mesh, by sorting the sides of its triangles; O(V + F).
 *
 * view      triangles must be valid
 * set       on success the caller owns it (edge_set_release)
 * returns   0, or -1 and *err when memory ran out */
int edge_set_make(const struct mesh_view *view, struct edge_set *set, struct error *err) MUST_CHECK;
void edge_set_release(struct edge_set *set);

/* The edge {a,b}, or NULL when no triangle joins the two. Both must be vertices of the mesh. */
struct listed_edge *edge_set_find(const struct edge_set *set, int32_t a, int32_t b);

#endif
