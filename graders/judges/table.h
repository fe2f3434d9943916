/* Every judge of this program. The build writes the table from the files in graders/judges. */
#ifndef GRADERS_JUDGES_TABLE_H
#define GRADERS_JUDGES_TABLE_H

#include "graders/library/judge.h"

/* NULL-terminated. */
extern const struct judge *const judge_table[];

/* The judge of an exercise, NULL when there is none. */
const struct judge *judge_find(const char *exercise);

#endif
