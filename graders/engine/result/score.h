/* From a trial to marks: the result that is stored, in the format of graders/report/README.md. */
#ifndef GRADERS_ENGINE_RESULT_SCORE_H
#define GRADERS_ENGINE_RESULT_SCORE_H

#include "graders/engine/run/trial.h"

#include <jansson.h>

/* What grading one submission gives. */
struct outcome {
    json_t *result; /* meshgrade-result-1; owned */
    char *scenes;   /* JSON text of an object: case name -> scene; owned, by malloc */
};

struct submitter {
    const char *student;        /* as found; untrusted, valid UTF-8 */
    const char *student_folder; /* safe file name */
};

/* The result of a trial that ran to its end. Takes the scenes out of the trial.
 * Returns 0, or -1 and *err when out of memory; outcome_release follows. */
int score_trial(struct trial *trial, const struct submitter *submitter, struct outcome *outcome,
                struct error *err) MUST_CHECK;

/* The result of a submission that could not be taken, or whose grading failed.
 *
 * verdict   COMPILE_ERROR with the upload's refusal, or FAULT with our own error
 * exercise  may be NULL for a refusal before the exercise could be told */
int score_without_trial(const struct exercise *exercise, const struct submitter *submitter,
                        enum verdict verdict, const struct refusal *why, struct outcome *outcome,
                        struct error *err) MUST_CHECK;

void outcome_release(struct outcome *outcome);

/* The version of the program, "0.1.0". */
const char *meshgrade_version(void);

#endif
