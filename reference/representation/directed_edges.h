/* Directed edges (Campagna, Kobbelt and Seidel 1998): half edges of triangles, where the number of
 * a directed edge says in which triangle it is and what comes before and after it. Beside the
 * course. Of the three sizes in the paper this is the one without stored next and previous.
 *
 *                  v                        here                  what it is
 *                / ^ \                      edges[e].vertex       vertex where e starts
 *              /   |   \                    edges[e].neighbour    the one that runs against e
 *            /     |     \                  e / 3                 its triangle
 *          /   t   |  n    \                next(e), previous(e)  e + 1, e - 1 within its triangle
 *          \     e |       /                vertex_edge           one that leaves each vertex
 *            \     |     /
 *              \   |   /                    e runs from u to v with triangle t = e / 3 to its left;
 *                \ | /                      n = neighbour / 3 is the triangle to its right.
 *                  u
 *
 * Triangles only. The paper gives negative references to edges without a neighbour, to be used as
 * one likes; here they lead along the hole: when e = u -> v is on the boundary, ~neighbour is the
 * boundary edge that leaves v. So loops are walked without a search, at no cost in memory.
 *
 * Invariants (directed_edges_check):
 *  - vertex is in range, and the three of a triangle differ;
 *  - neighbour(neighbour(e)) = e, and it starts where e ends and ends where e starts;
 *  - a negative one names a boundary edge that starts where e ends, and no two name the same;
 *  - vertex_edge(v) leaves v (-1: isolated); where v is on the boundary it is the boundary edge
 *    that leaves v, so that turning counter-clockwise from it meets every triangle of v: one fan.
 *
 * It refuses degenerate triangles, edges with more than two triangles, edges that two triangles run
 * through in the same direction, and vertices whose triangles are not one fan. It holds isolated
 * vertices.
 *
 * Bytes: 24 a triangle, 16 a vertex (12 of them its position); a large closed mesh takes 32 a
 * triangle, 64 a vertex. Accesses, for a vertex of k triangles: next, previous, triangle none;
 * corners or neighbours of a triangle 1, three entries side by side; around a vertex, is it an
 * edge: k. */
#ifndef REFERENCE_REPRESENTATION_DIRECTED_EDGES_H
#define REFERENCE_REPRESENTATION_DIRECTED_EDGES_H

#include "reference/mesh/mesh.h"

#include <stdbool.h>
#include <stdint.h>

struct directed_edge {
    int32_t vertex;
    int32_t neighbour; /* negative: none; ~neighbour is the next edge of the boundary loop */
};

struct directed_edge_mesh {
    float *positions;            /* 3 a vertex */
    int32_t *vertex_edge;        /* one that leaves each vertex; -1: isolated */
    struct directed_edge *edges; /* 3 a triangle, in the order of its sides */
    int32_t vertex_count;
    int32_t triangle_count;
};

/* Builds from a valid mesh; directed edge 3 t + i is side i of triangle t.
 *
 * de       its old contents are not looked at; on success the caller owns it
 * returns  0, or -1 and *err naming what it refuses (above), or out of memory; then *de is empty
 * cost     linear */
int directed_edges_build(struct directed_edge_mesh *de, const struct mesh *mesh,
                         struct error *err) MUST_CHECK;

/* Frees the tables and leaves the empty mesh; a zeroed one may be released. */
void directed_edges_release(struct directed_edge_mesh *de);

/* Checks the invariants. Returns 0, or -1 and *err naming the element at fault. Linear. */
int directed_edges_check(const struct directed_edge_mesh *de, struct error *err) MUST_CHECK;

/* The indexed mesh, exactly as it was; the caller owns it. Returns 0, or -1 and *err. */
int directed_edges_to_mesh(const struct directed_edge_mesh *de, struct mesh *mesh,
                           struct error *err) MUST_CHECK;

/* -- steps ----------------------------------------------------------------------------------- */

static inline int32_t directed_edge_next(int32_t edge)
{
    return edge % 3 == 2 ? edge - 2 : edge + 1;
}

static inline int32_t directed_edge_previous(int32_t edge)
{
    return edge % 3 == 0 ? edge + 2 : edge - 1;
}

/* The one that leaves the same vertex next, counter-clockwise; negative when there is none. */
static inline int32_t directed_edge_turn_left(const struct directed_edge_mesh *de, int32_t edge)
{
    return de->edges[directed_edge_previous(edge)].neighbour;
}

/* Whether a vertex is an end of a boundary edge. */
static inline bool directed_edge_on_boundary(const struct directed_edge_mesh *de, int32_t vertex)
{
    int32_t edge = de->vertex_edge[vertex];
    return edge >= 0 && de->edges[edge].neighbour < 0;
}

#endif
