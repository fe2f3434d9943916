/* Topology checks of a valid mesh (mesh_check), each a plain kernel of linear cost. Made for tests
 * and for looking at models; a judge may use them on meshes that it made itself.
 *
 * A finding is a count and the first element at fault. */
#ifndef REFERENCE_MESH_CHECK_H
#define REFERENCE_MESH_CHECK_H

#include "reference/mesh/edges.h"
#include "reference/mesh/mesh.h"

#include <stdbool.h>
#include <stdint.h>

struct finding {
    int64_t count; /* elements at fault */
    int64_t first; /* number of the first one, -1 when there is none */
};

/* -- edges: `first` is an index into list->edges ------------------------------------------------
 */

/* Edges with one triangle: the mesh is open there. */
struct finding mesh_boundary_edges(const struct edge_list *list);

/* Edges with more than two triangles. */
struct finding mesh_nonmanifold_edges(const struct edge_list *list);

/* Edges whose two triangles run through it in the same direction: neighbours disagree which side is
 * outside. Edges with more than two triangles are not looked at. */
struct finding mesh_incoherent_edges(const struct edge_list *list);

/* -- triangles ------------------------------------------------------------------------------ */

/* Triangles with two corners at the same vertex. */
struct finding mesh_degenerate_triangles(const struct mesh *mesh);

/* Triangles that name the same three vertices as an earlier one, in any order or winding.
 * Returns 0, or -1 and *err (out of memory). */
int mesh_duplicate_triangles(const struct mesh *mesh, struct finding *found,
                             struct error *err) MUST_CHECK;

/* -- vertices ------------------------------------------------------------------------------- */

/* Vertices that no triangle uses. Returns 0, or -1 and *err (out of memory). */
int mesh_isolated_vertices(const struct mesh *mesh, struct finding *found,
                           struct error *err) MUST_CHECK;

/* Vertices whose triangles are not one fan (open) or one umbrella (closed): an edge at the vertex
 * has more than two triangles, or its triangles fall apart into several groups that share no edge
 * there, as at the apex of two cones. Degenerate triangles and isolated vertices are not looked at.
 * `list` holds the edges of the mesh. Returns 0, or -1 and *err (out of memory). */
int mesh_nonmanifold_vertices(const struct mesh *mesh, const struct edge_list *list,
                              struct finding *found, struct error *err) MUST_CHECK;

/* The number of such fans and umbrellas of every vertex, of which one is manifold; at least 2 where an
 * edge has more than two triangles. fan_counts has vertex_count entries. Returns 0, or -1 and *err
 * (out of memory). */
int mesh_count_fans(const struct mesh *mesh, const struct edge_list *list, int32_t *fan_counts,
                    struct error *err) MUST_CHECK;

/* -- the whole ------------------------------------------------------------------------------ */

struct topology {
    int64_t vertex_count, edge_count, triangle_count;
    int64_t euler_characteristic; /* V - E + F over used vertices and triangles not degenerate */
    int64_t component_count;      /* groups of triangles that hang together by vertices */
    int64_t boundary_loop_count;  /* groups of boundary edges that hang together by vertices */
    bool is_orientable;           /* flipping triangles can make it coherent; see below */
    struct finding boundary, nonmanifold_edge, incoherent; /* edges */
    struct finding degenerate, duplicate;                  /* triangles */
    struct finding isolated, nonmanifold_vertex;           /* vertices */
};

/* All of the above at once. is_orientable asks whether some choice of windings makes every edge
 * with two triangles coherent; edges with more are not looked at. Returns 0, or -1 and *err (out of
 * memory). Cost: linear but for an inverse Ackermann factor. */
int mesh_topology(const struct mesh *mesh, struct topology *topology, struct error *err) MUST_CHECK;

/* The same for one who has the edges of the mesh already. */
int mesh_topology_of_edges(const struct mesh *mesh, const struct edge_list *list,
                           struct topology *topology, struct error *err) MUST_CHECK;

#endif
