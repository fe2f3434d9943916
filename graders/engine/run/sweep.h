/* The step of a trial in which memory runs out: every allocation of some cases is refused in turn. */
#ifndef GRADERS_ENGINE_RUN_SWEEP_H
#define GRADERS_ENGINE_RUN_SWEEP_H

#include "graders/engine/run/trial.h"

/* After the cases. Returns 0, or -1 and *err: a fault. */
int sweep_check(struct trial *trial, struct error *err) MUST_CHECK;

#endif
