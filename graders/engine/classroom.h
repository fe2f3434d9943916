/* Grades a class: many submissions, several at a time, one child process each.
 *
 *   for each exercise: make the yardstick (reference built, run and counted once)
 *     for each submission that the store does not have yet: a child grades it and hands back JSON,
 *     the parent stores it in one transaction
 *   the last children of an exercise run on while the next yardstick is made
 *
 * Killed at any moment, the next run goes on where this one stopped, and ends with the same
 * results. A fault is tried again once; then it is stored as a fault, which is never scored. So is
 * a yardstick that cannot be made: a fault of each submission to its exercise, and of no other. */
#ifndef GRADERS_ENGINE_CLASSROOM_H
#define GRADERS_ENGINE_CLASSROOM_H

#include "graders/engine/result/store.h"
#include "graders/engine/upload/upload.h"

struct classroom {
    const struct exercise *exercises; /* borrowed */
    int exercise_count;
    const struct upload_list *uploads; /* borrowed */
    struct store *store;               /* borrowed */
    uint32_t seed;                     /* of the class, or SEED_PUBLISHED; see inputs.h */
    int job_count;
    bool regrade;     /* grade even what the store has (and keep faults out of the way) */
    bool keep_others; /* leave results of submissions that are not in `uploads` */
    json_t *changes;  /* with regrade: array of {student, exercise, before, after}; not stored
                         unless `apply` */
    bool apply;
    bool mixes; /* grade on where the store has results of other tools (toolset.h): else
                               that is an error, before anything is graded */
    const unsigned *left_out; /* of each upload, the steps that are not run, see trial_scope;
                                 borrowed; NULL: none */
    /* Called in the parent after each result; done and total count submissions. May be NULL. */
    void (*progress)(const struct classroom *classroom, const json_t *result, int done, int total);
    int done, total;
};

/* Grades. Returns 0 (also when results hold faults), or -1 and *err: the store cannot be written, or
 * holds results of other tools, or no worker can be started. */
int classroom_grade(struct classroom *classroom, struct error *err) MUST_CHECK;

/* Grades one submission in this process: the whole way from sources to outcome.
 * Returns 0, or -1 and *err: a fault, nothing in *outcome. */
int grade_submission(struct yardstick *yardstick, const struct upload *upload,
                     const struct trial_scope *scope, struct outcome *outcome,
                     struct error *err) MUST_CHECK;

#endif
