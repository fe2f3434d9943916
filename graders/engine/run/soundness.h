/* Whether an exercise and its judge fit together: what does not is refused when the exercises are
 * loaded, before a student can meet it. */
#ifndef GRADERS_ENGINE_RUN_SOUNDNESS_H
#define GRADERS_ENGINE_RUN_SOUNDNESS_H

#include "graders/engine/base/exercise.h"
#include "graders/library/judge.h"

/* Checks one exercise against its judge: the same classes, each with cases; names of cases and
 * families unique, seeds distinct; some cases public and some quick; families where growth is
 * judged, as many as are measured.
 *
 * judge    NULL: this program has none, which is refused, too
 * returns  0, or -1 and *err: names the file and what to do there */
int soundness_check(const struct exercise *exercise, const struct judge *judge,
                    struct error *err) MUST_CHECK;

/* Reads every exercise (exercises_read) and checks each against the judge of its name. One without
 * a judge is listed, since it may be in the making; it is refused when something is to be graded.
 */
int soundness_read(const char *root, struct exercise **exercises, int *count,
                   struct error *err) MUST_CHECK;

#endif
