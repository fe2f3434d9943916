/* The judge library: what an exercise author needs, in one place, with an example of each part.
 *
 * A judge is three declarations and one function. This is all of edge-table-closed's:
 *
 *     static const struct judge_case cases[] = {
 *         CASES_CLOSED(1), CASES_GENUS(11), CASES_HIGH_NUMBERS(41), CASES_EMPTY(51),
 *         {"bipyramid-60", "closed", 7, QUICK,
 *          .mesh = {SHAPE_BIPYRAMID, .count = 60, .changes = SCRAMBLED}},
 *     };
 *     static const struct size_family families[] = {
 *         {"sphere-scrambled", FAMILY_SPHERE, SCRAMBLED}, {NULL}};
 *     static const struct answer_rule answer = EDGE_TABLE_ANSWER("edge_table_closed");
 *     const struct judge judge_edge_table_closed = {
 *         .exercise = "edge-table-closed", .cases = cases, .case_count = ..., .families = families,
 *         .input = INPUT_TOPOLOGY, .answer = &answer, .judge = edge_table_judge};
 *
 * and its runner is one line: CALL_TABLE(edge_table_closed, TRIANGLES, int32_t, 2)
 *
 *
 * 1. Inputs: what the function gets
 *
 *   recipe.h    triangle meshes by name and parameters, and what is done to them
 *                   .mesh = {SHAPE_TORUS, .genus = 2, .triangles = 1200, .changes = SCRAMBLED}
 *   polygons.h  faces of any size, from the same recipes (INPUT_POLYGONS)
 *                   .mesh = {SHAPE_PRISM, .count = 7}
 *   lines.h     points, polylines, polygons of the plane (INPUT_LINE)
 *                   .line = {LINE_SPIRAL, .count = 40, .scrambled = true}
 *   fields.h    height fields and volumes (INPUT_FIELD)
 *                   .field = {FIELD_TORUS, .rows = 16, .columns = 16, .layers = 16}
 *   mesh_input.h  a soup (INPUT_SOUP): the triangles of a recipe, nine floats each
 *   cases.h     standard cases, class by class: CASES_OPEN(11), ...
 *   families.h  inputs of any exact size, on which growth, work and memory are measured
 *   attributes.h  numbers for each vertex, corner or face, given with the mesh
 *                   .attributes = {{PER_CORNER, 2, ATTRIBUTE_RANDOM}}
 *   judge.h     .write_beside: what is computed from the input and given with it: a structure of the
 *               mesh, a list of the elements that are asked for
 *   .number     up to four integers that are given beside (struct judge's `numbers` says how many):
 *               an element that is asked for, a tolerance, a count
 *
 *
 * 2. Answers: what it gives back
 *
 *   answer.h    declared once; read, bounded and looked through before judge() is called. Tables of
 *               k numbers, several of them, rows of unequal length, arrays of the caller's, a
 *               attribute for each vertex, corner or face (ANSWER_PER_CORNER), a count, a status, a
 *               real; NULL, negative or huge counts, offsets and indices out of range are
 *               named there, for all exercises in the same words
 *   questions.h exercises that ask several formulas, numbers and builders; formula.h judges these
 *   a judge that declares no answer reads task->said by a struct reader (wire/packet.h)
 *
 *
 * 3. Comparing
 *
 *   tuples.h    sets of tuples up to order, reversal, rotation
 *                   tuples_compare(answer, n, right, m, 3, TUPLES_ROTATED, &fault, err)
 *   cycles.h    sets of cyclic sequences: the first step that differs, reversed ones
 *   partition.h labels up to their names
 *   topology.h  edges, fans, loops, components, Euler number of an input or of an answer
 *   structure.h winged edges and half edges against their faces: which entry is wrong
 *   winged_judge.h  the same judged, said and shown, with the wings
 *   neighbours.h  queries for what touches a face, a vertex, an edge: which number is wrong
 *   refusal.h   faces that such structures cannot hold: which refusal is right, and why
 *   surface.h   meshes up to the numbers of vertices, told by a table or by position
 *   tolerance.h reals by absolute, relative, ulp and angular tolerance; usual mistakes recognised
 *   tiling.h    triangles that tile a polygon, by exact predicates (plane.h)
 *   distance.h  how far surfaces are apart
 *   hints.h     what all wrong elements have in common; ready-made: topology_hints.h
 *                   judge_hint(out, hint_find(rules, count, &context, edge_count, is_missing))
 *   edge_table.h  tables of edges, with the usual mistakes recognised (edge_hints.h)
 *   lattice.h, sphere.h  grids and spheres by where their vertices lie
 *   mesh_area.h exact areas
 *
 *
 * 4. Saying it (judgement.h, reference/base/phrase.h)
 *
 *     static const struct cause lost = {"missing-edge", {"missing edge", "falta una arista"}};
 *
 *     judge_name_one(out, edge_noun, "{%d,%d}", a, b);
 *     judge_reject(out, &lost, "edge {%d,%d} is missing.", "falta la arista {%d,%d}.", a, b);
 *     judge_hint(out, hint);      a reason, only one that was computed from the numbers
 *
 *     judge_quality(out, indices / triangles);    a right answer's number; classes may set bands for
 *                                                 it, which the library judges (quality.h)
 *     accesses_reject(task->usage, least, out)    counted calls of functions that the exercise gives:
 *                                                 can the count be true? (accesses.h)
 *
 *   The first sentence is of this case, what follows is the hint. Words stand where the thing is
 *   declared; no list elsewhere is edited.
 *
 *
 * 5. Showing it (graders/scene)
 *
 *     task_show(task, out, err);                           the input, before any mark: a mark on no
 *                                                          vertex of it is not drawn
 *     scene_mark_edge(&out->scene, MARK_MISSING, a, b);    first what the verdict names: pictures
 *     scene_mark_arrow(&out->scene, MARK_WRONG, a, b);     magnify the first mark
 *     scene_mark_path(&out->scene, mark_turn(i), vertices, n, true);
 *     scene_label_face(&out->scene, corners, n, number);
 */
#ifndef GRADERS_LIBRARY_LIBRARY_H
#define GRADERS_LIBRARY_LIBRARY_H

#include "graders/library/accesses.h"
#include "graders/library/cases.h"
#include "graders/library/cycles.h"
#include "graders/library/distance.h"
#include "graders/library/edge_table.h"
#include "graders/library/judge.h"
#include "graders/library/lattice.h"
#include "graders/library/mesh_area.h"
#include "graders/library/neighbours.h"
#include "graders/library/partition.h"
#include "graders/library/questions.h"
#include "graders/library/refusal.h"
#include "graders/library/sphere.h"
#include "graders/library/structure.h"
#include "graders/library/surface.h"
#include "graders/library/tiling.h"
#include "graders/library/tolerance.h"
#include "graders/library/topology.h"
#include "graders/library/topology_hints.h"
#include "graders/library/tuples.h"
#include "graders/library/winged_judge.h"
#include "graders/scene/show.h"

#endif
