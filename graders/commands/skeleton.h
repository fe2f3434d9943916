/* A new exercise as a copy of one that is there, under another name: what `meshgrade new` writes.
 */
#ifndef GRADERS_COMMANDS_SKELETON_H
#define GRADERS_COMMANDS_SKELETON_H

#include "graders/engine/base/exercise.h"

struct skeleton {
    const struct exercise *like; /* what is copied */
    char group[EXERCISE_NAME], name[EXERCISE_NAME];
    int order;                      /* a place in lists that no exercise has */
    void (*tell)(const char *path); /* called for each file that was written */
};

/* Splits "group/name". Both begin with a letter and have lower case letters, digits and dashes.
 * Returns 0, or -1 and *err. */
int skeleton_name(const char *text, struct skeleton *skeleton, struct error *err) MUST_CHECK;

/* Writes all parts: statement, header, starter, exercise.json, reference answer, runner, judge and
 * every submission of known verdict. The name is replaced wherever it stands by itself, also as
 * part of C names; title and problem become blanks to be filled in. Nothing that is there is
 * overwritten. Returns 0, or -1 and *err. */
int skeleton_write(const struct skeleton *skeleton, struct error *err) MUST_CHECK;

/* A text in which `from` is called `to`: edge-table-closed, edge_table_closed, EDGE_TABLE_CLOSED_H
 * and judge_edge_table_closed, where they stand by themselves; the library's own files in #include
 * lines keep their names.
 *
 * returns  malloc'ed, ended by a zero byte; NULL when memory runs out */
char *skeleton_renamed(const char *text, const char *from, const char *to);

#endif
