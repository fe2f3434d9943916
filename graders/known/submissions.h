/* Submissions whose verdict is known: tests/submissions/<group>/<exercise>/<kind>/, one an entry,
 * as a whole file NAME.c or as a change of one, NAME.change (change.h). The kind is the folder:
 * right, wrong, poor, slow, greedy, crash, leak, hostile. Right ones are whole files. */
#ifndef GRADERS_KNOWN_SUBMISSIONS_H
#define GRADERS_KNOWN_SUBMISSIONS_H

#include "graders/known/expectation.h"
#include "reference/base/error.h"

#include <stdbool.h>
#include <stddef.h>

struct known_submission {
    char *file;   /* <kind>/<name>.c, however it is stored */
    char *stored; /* path of what is stored */
    char *text;   /* the whole source; a zero byte stands after the last one */
    size_t count;
    struct expectation expected;
};

struct known_list {
    struct known_submission *submissions; /* sorted by file */
    int count;
};

/* Reads every submission of an exercise, changes applied.
 *
 * root     the project's folder
 * list     release with known_release, also after an error
 * returns  0 (also when there is none), or -1 and *err: names the file, what is wrong in it and
 *          what to do. A folder or file whose name means nothing here is wrong, too. */
int known_read(const char *root, const char *group, const char *exercise, struct known_list *list,
               struct error *err) MUST_CHECK;

/* The one called <kind>/<name>.c, or NULL. */
const struct known_submission *known_find(const struct known_list *list, const char *file);

/* Whether it stands in the folder of that kind. */
bool known_is(const struct known_submission *submission, const char *kind);

/* Drops those whose entry in `kept` is false. */
void known_keep(struct known_list *list, const bool *kept);

/* Writes every one as a whole file below `folder`, as <kind>/<name>.c. */
int known_write(const struct known_list *list, const char *folder, struct error *err) MUST_CHECK;

void known_release(struct known_list *list);

#endif
