/* The steps of a trial on sized inputs, as far as the exercise checks them: memory, then growth and
 * work. */
#ifndef GRADERS_ENGINE_RUN_SIZED_H
#define GRADERS_ENGINE_RUN_SIZED_H

#include "graders/engine/run/trial.h"

/* After the cases. *right: no call went wrong, so that growth can be looked at. Returns 0, or -1 and
 * *err: a fault. */
int sized_check_memory(struct trial *trial, bool *right, struct error *err) MUST_CHECK;

/* After the memory. Returns 0, or -1 and *err: a fault. */
int sized_check_growth(struct trial *trial, struct error *err) MUST_CHECK;

/* Both. */
int sized_check(struct trial *trial, struct error *err) MUST_CHECK;

#endif
