/* A trial: one submission on one exercise, step by step, and everything that was found out. The
 * steps are cases.h, undefined.h, sweep.h and sized.h. */
#ifndef GRADERS_ENGINE_RUN_TRIAL_H
#define GRADERS_ENGINE_RUN_TRIAL_H

#include "bench/measure/growth.h"
#include "graders/engine/run/check.h"
#include "graders/engine/run/yardstick.h"

struct case_result {
    bool run; /* false: left out of this trial */
    struct attempt attempt;
};

/* How the work of one family grew. */
struct family_result {
    int size_count; /* sizes counted */
    bool hopeless;
    struct cost costs[SIZES_MAX];
    bool fitted;
    struct growth_fit fit;
};

/* The steps of a trial, for the question where the time goes. */
enum trial_stage {
    STAGE_BUILD,
    STAGE_CASES,
    STAGE_UNDEFINED_BEHAVIOUR,
    STAGE_ALLOCATION_FAILURE,
    STAGE_MEMORY,
    STAGE_GROWTH,
    STAGE_COUNT
};

/* The steps after the cases, as bits. */
enum { TRIAL_CHECKS = (1 << STAGE_COUNT) - (1 << STAGE_UNDEFINED_BEHAVIOUR) };

/* What to run. */
struct trial_scope {
    bool public_only;      /* only cases that students see */
    bool quick;            /* only quick cases; no check but leak */
    unsigned left_out;     /* bits of TRIAL_CHECKS: steps that are not run */
    const char *only_case; /* NULL: all */
    int64_t budget_ns;     /* what all runs may take together; 0: BUDGET_SECONDS */
    int64_t *stage_cpu_ns; /* [STAGE_COUNT], gets the CPU time of each step; NULL: not wanted */
};

/* Ratios to the reference of the worst family, at the largest size; 0: unknown. */
struct part_result {
    double work_ratio, instruction_ratio, miss_ratio;
    double memory_ratio;
    int memory_family, memory_size; /* indices of where that was */
};

struct trial {
    struct yardstick *yardstick;
    const char *student; /* borrowed */
    const struct source *sources;
    int source_count;
    struct trial_scope scope;
    struct build build;
    struct budget budget;
    struct case_result *cases; /* judge->case_count */
    struct check_result checks[CHECK_COUNT];
    struct family_result families[FAMILIES_MAX];
    struct part_result parts[PART_COUNT];
    double access_ratio;
    int access_family;
    uint32_t active_layers; /* of the box in which the cases ran */
    struct box_reason layer_reasons[BOX_LAYER_COUNT];
    char output[ATTEMPT_OUTPUT];
};

/* Runs every step of the scope. Returns 0, or -1 and *err: a fault; trial_release must follow. The
 * strings and sources are borrowed for the trial's life. */
int trial_run(struct trial *trial, struct yardstick *yardstick, const char *student,
              const struct source *sources, int source_count, const struct trial_scope *scope,
              struct error *err) MUST_CHECK;

void trial_release(struct trial *trial);

#endif
