/* The step of a trial that looks for undefined behaviour: the cases again under ASan and UBSan,
 * then under memcheck. */
#ifndef GRADERS_ENGINE_RUN_UNDEFINED_H
#define GRADERS_ENGINE_RUN_UNDEFINED_H

#include "graders/engine/run/trial.h"

/* After the cases. Returns 0, or -1 and *err: a fault. */
int undefined_check(struct trial *trial, struct error *err) MUST_CHECK;

#endif
