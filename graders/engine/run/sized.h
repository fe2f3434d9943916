/* The step of a trial on sized inputs: memory, growth and work, as far as the exercise checks them. */
#ifndef GRADERS_ENGINE_RUN_SIZED_H
#define GRADERS_ENGINE_RUN_SIZED_H

#include "graders/engine/run/trial.h"

/* After the cases. Returns 0, or -1 and *err: a fault. */
int sized_check(struct trial *trial, struct error *err) MUST_CHECK;

#endif
