/* A known-verdict submission that is stored as its difference to another one:
 *
 *     / * Counts boundary edges twice.
 *      * of: right/sort.c
 *      * fails: open, several-components * /
 *              if (i < j)
 *     -            sides[side_count++] = (struct side){i, j};
 *     +            sides[side_count++] = (struct side){j, i};
 *     @@
 *     -    free(sides);
 *
 * The first comment takes the place of the base's. `of:` names the base: a whole file of the same
 * exercise, <kind>/<file>.c, or `reference`, the reference answer. Then come the places that
 * differ, parted by lines `@@`: a line begins with a space when both have it, with - when only the
 * base has it, with + when only the new text has it; an empty line is one that both have. What a
 * place says of the base must stand there exactly, once, and behind the place before; otherwise
 * the change is refused. */
#ifndef GRADERS_KNOWN_CHANGE_H
#define GRADERS_KNOWN_CHANGE_H

#include "reference/base/error.h"

#include <stddef.h>

enum { CHANGE_BASE_BYTES = 256 };

/* A text and what it is called in errors. */
struct change_text {
    const char *name;
    const char *bytes;
    size_t count;
};

/* Finds what stands after `of:`.
 *
 * returns  0, or -1 and *err: no comment at the beginning, no such line, a name that is neither
 *          `reference` nor <kind>/<file>.c */
int change_find_base(const struct change_text *change, char base[CHANGE_BASE_BYTES],
                     struct error *err) MUST_CHECK;

/* The whole text that a change stands for.
 *
 * text     on success the caller frees it; a zero byte stands after the last one
 * returns  0, or -1 and *err, which names the change's file and line and what to do there */
int change_apply(const struct change_text *change, const struct change_text *base, char **text,
                 size_t *count, struct error *err) MUST_CHECK;

#endif
