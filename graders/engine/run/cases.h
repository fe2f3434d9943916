/* The first step of a trial: every case of its scope, each in a fresh box. */
#ifndef GRADERS_ENGINE_RUN_CASES_H
#define GRADERS_ENGINE_RUN_CASES_H

#include "graders/engine/run/trial.h"

/* Runs them. Returns 0, or -1 and *err: a fault. */
int cases_run(struct trial *trial, struct error *err) MUST_CHECK;

/* Whether a scope takes in a case. */
bool cases_in_scope(const struct judge_case *c, const struct trial_scope *scope);

/* Whether the first class of the exercise passed whole. */
bool cases_basic_class_passed(const struct trial *trial);

/* Whether a case that was run has no right answer. */
bool cases_any_failed(const struct trial *trial);

#endif
