/* Judging a table of the edges of a mesh: shared by the exercises that ask for one.
 *
 * Input: a mesh packet (mesh_case.h). Answer: a table (write_table) of int32[2]. An answer is right
 * when it is the set of the mesh's edges, each once, in any order and direction. The properties are
 * looked at in this order, and the first that fails is the cause of the rejection:
 *
 *     malformed-answer     the bytes are no table (only code that tampers gets here)
 *     impossible-count     the count is negative, or more than any answer could hold
 *     no-table             the count is positive and there is no table
 *     index-out-of-range   an entry names a vertex that the mesh does not have
 *     self-edge            an entry joins a vertex to itself
 *     duplicate-edge       an edge is listed more than once
 *     extra-edge           an entry joins two vertices that no triangle joins
 *     missing-edge         an edge of the mesh is not listed
 *
 * A set with none of these has the right count. The scene of a rejection marks what is missing,
 * listed again and extra, and the boundary edges of an open mesh. */
#ifndef GRADERS_LIBRARY_EDGE_TABLE_H
#define GRADERS_LIBRARY_EDGE_TABLE_H

#include "graders/judges/judge.h"

/* See struct judge. Room for six entries a triangle: every side in both directions. */
size_t edge_table_answer_bound(struct span input);
int edge_table_judge(struct span input, struct span answer, const struct usage *usage,
                     struct judgement *out, struct error *err);

#endif
