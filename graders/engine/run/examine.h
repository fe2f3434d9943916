/* Asks a judge about an answer, in a process of its own: the answer may be anything, and a judge
 * that crashes or hangs is our fault, which must not take the engine down. */
#ifndef GRADERS_ENGINE_RUN_EXAMINE_H
#define GRADERS_ENGINE_RUN_EXAMINE_H

#include "graders/library/judge.h"

#include <jansson.h>

struct examination {
    struct judgement judgement; /* its scene is empty: see `scene` */
    json_t *scene;              /* what to show, NULL when there is nothing; the caller's */
};

/* Judges `answer` (copied bytes that nobody else can change) to `input`.
 *
 * c         the case that is answered and whose class's band of quality counts; NULL: none
 * usage     may have known == false
 * returns   0, or -1 and *err: the judge crashed, hung for 60 s of CPU, or said that it failed */
int examine(const struct judge *judge, const struct judge_case *c, struct span input,
            struct span answer, const struct usage *usage, struct examination *examination,
            struct error *err) MUST_CHECK;

void examination_release(struct examination *examination);

#endif
