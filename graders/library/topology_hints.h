/* Ready-made hints (hints.h) for elements of a mesh that an answer lacks. The context of all is the
 * struct face_topology of the input.
 *
 *     judge_hint(out, hint_find_marked(topology_edges_lost, TOPOLOGY_EDGES_LOST, &t, t.edge_count,
 *                                      fault.right_marks, SET_MISSING));
 *
 * Where the elements are others than those of the tables, make a table of the predicates. */
#ifndef GRADERS_LIBRARY_TOPOLOGY_HINTS_H
#define GRADERS_LIBRARY_TOPOLOGY_HINTS_H

#include "graders/library/hints.h"
#include "graders/library/topology.h"

/* Elements are indices into t->edges. */
enum { TOPOLOGY_EDGES_LOST = 11 };
extern const struct hint_rule topology_edges_lost[TOPOLOGY_EDGES_LOST];
hint_predicate topology_edge_in_last_face; /* of the last face, of several, and none before it */
hint_predicate topology_edge_at_first;     /* at vertex 0 */
hint_predicate topology_edge_at_last;      /* at the last vertex */
hint_predicate topology_edge_elsewhere;    /* in another component than the first face */
hint_predicate topology_edge_never_up;     /* no face runs it from the smaller number */
hint_predicate topology_edge_never_down;
hint_predicate topology_edge_closing; /* always the side from a last corner to the first */
hint_predicate topology_edge_on_boundary;
hint_predicate topology_edge_inside;      /* two sides */
hint_predicate topology_edge_nonmanifold; /* more than two */
hint_predicate topology_edge_at_large;    /* at a vertex of more than 8 faces */

/* Elements are numbers of vertices. */
enum { TOPOLOGY_VERTICES_LOST = 7 };
extern const struct hint_rule topology_vertices_lost[TOPOLOGY_VERTICES_LOST];
hint_predicate topology_vertex_first;
hint_predicate topology_vertex_last;
hint_predicate topology_vertex_isolated;
hint_predicate topology_vertex_on_boundary;
hint_predicate topology_vertex_nonmanifold;
hint_predicate topology_vertex_elsewhere;
hint_predicate topology_vertex_large;

/* Elements are faces. */
enum { TOPOLOGY_FACES_LOST = 5 };
extern const struct hint_rule topology_faces_lost[TOPOLOGY_FACES_LOST];
hint_predicate topology_face_first;
hint_predicate topology_face_last;
hint_predicate topology_face_degenerate;
hint_predicate topology_face_elsewhere;
hint_predicate topology_face_on_boundary; /* has a boundary edge */

/* Elements are boundary loops of t, which has loop_first. */
enum { TOPOLOGY_LOOPS_LOST = 3 };
extern const struct hint_rule topology_loops_lost[TOPOLOGY_LOOPS_LOST];
hint_predicate topology_loop_not_first;
hint_predicate topology_loop_of_three;
hint_predicate topology_loop_elsewhere;

#endif
