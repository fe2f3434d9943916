/* The step of a trial in which memory runs out: the allocations of some cases are refused in turn. */
#ifndef GRADERS_ENGINE_RUN_SWEEP_H
#define GRADERS_ENGINE_RUN_SWEEP_H

#include "graders/engine/run/trial.h"

enum { SWEEP_FIRST = 8, SWEEP_MOST = 2 * SWEEP_FIRST };

/* Which of so many allocations are refused, one in each call: all when there are few; else the first,
 * and of the rest one in each of as many equal parts, drawn by the seed, odd and even ones by turns.
 * The numbers rise, from 1. Returns how many. */
int sweep_choose(int64_t allocations, uint64_t seed, int64_t chosen[SWEEP_MOST]);

/* After the cases. Returns 0, or -1 and *err: a fault. */
int sweep_check(struct trial *trial, struct error *err) MUST_CHECK;

#endif
