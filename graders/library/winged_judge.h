/* Judges winged edges against their faces: says the first fault, names it, shows it with its faces
 * and wings, and gives a hint where the numbers hold one.
 *
 *     struct structure_answer answer = {STRUCTURE_WINGED_EDGE, rows, structure_winged_get,
 *                                       edge_count, vertex_edge, face_edge};
 *     if (winged_judge(&faces, &answer, out, err))
 *         return -1;
 *     return out->accepted ? 0 : task_show(task, out, err); */
#ifndef GRADERS_LIBRARY_WINGED_JUDGE_H
#define GRADERS_LIBRARY_WINGED_JUDGE_H

#include "graders/library/judgement.h"
#include "graders/library/structure.h"

/* Accepts or rejects, and puts marks and numbers into the scene of a rejection.
 *
 * faces    proper, coherent and manifold (refusal.h tells)
 * answer   vertices and faces in the rows are in range or NONE, links are rows or NONE
 * returns  0, or -1 and *err (out of memory, other faces). O(n log n) */
int winged_judge(const struct face_table *faces, const struct structure_answer *answer,
                 struct judgement *out, struct error *err) MUST_CHECK;

#endif
