/* The yardstick of one exercise: its inputs, and what the reference needs for them on this machine.
 *
 * Made once a run and shared by all submissions (forked workers inherit it): the reference is
 * built, run and counted once. */
#ifndef GRADERS_ENGINE_RUN_YARDSTICK_H
#define GRADERS_ENGINE_RUN_YARDSTICK_H

#include "graders/engine/run/count.h"

/* Which probes this machine has. A probe that lacks is reported, and no mark rests on it. */
struct probes {
    bool valgrind;
    struct phrase no_valgrind; /* why not */
};

struct yardstick {
    struct inputs inputs;
    struct probes probes;
    struct build reference;
    int64_t *reference_cpu_ns;                  /* of each case, 0: not run yet */
    struct cost costs[FAMILIES_MAX][SIZES_MAX]; /* of the reference */
    bool quick;                                 /* made for `check --quick`: nothing is counted */
};

/* Builds and counts the reference.
 *
 * exercise   borrowed for the yardstick's life
 * quick      true: leave the counting out
 * returns    0, or -1 and *err (a fault: the reference must build, run and be accepted);
 *            yardstick_release must follow in both cases */
int yardstick_make(struct yardstick *yardstick, const struct exercise *exercise, struct seeds seeds,
                   bool quick, struct error *err) MUST_CHECK;

/* The input of a case; makes it, and runs the reference on it, when that was not done yet. */
int yardstick_case(struct yardstick *yardstick, size_t index, const struct input **input,
                   struct error *err) MUST_CHECK;

/* Makes the inputs (and reference runs) of every case now, so that forked workers share them. */
int yardstick_make_cases(struct yardstick *yardstick, bool public_only,
                         struct error *err) MUST_CHECK;

enum { CPU_LIMIT_MULTIPLE = 20, CPU_LIMIT_LEAST_SECONDS = 1 };

/* CPU time that a submission may take for a case: a generous multiple of the reference's. */
int64_t yardstick_cpu_limit_ns(const struct yardstick *yardstick, size_t index);

void yardstick_release(struct yardstick *yardstick);

#endif
