/* Judging a table of edges: every edge of the mesh once, in any order and direction. Shared by the
 * exercises that ask for the edges of a triangle mesh. */
#ifndef GRADERS_LIBRARY_EDGE_TABLE_H
#define GRADERS_LIBRARY_EDGE_TABLE_H

#include "graders/library/judge.h"

/* What such a function answers: a count, and a table made with malloc. */
#define EDGE_TABLE_ANSWER(name)                                                                    \
    {                                                                                              \
        .function = (name), .result = RESULT_COUNT, .counted = {"edges", "aristas"},               \
        .most = {.per_face = 3}, .parts = {                                                        \
            {.argument = "*edges", .row = {"edge", "arista"}, .columns = 2, .of = OF_VERTEX}       \
        }                                                                                          \
    }

/* Judges it. The first and smallest mistake is named: an edge from a vertex to itself, then one
 * that is listed twice, then one that is no edge of the mesh, then one that is missing; all are
 * shown. */
int edge_table_judge(const struct task *task, struct judgement *out, struct error *err);

#endif
