/* A trial: one submission on one exercise, step by step, and everything that was found out. */
#ifndef GRADERS_ENGINE_RUN_TRIAL_H
#define GRADERS_ENGINE_RUN_TRIAL_H

#include "graders/engine/run/count.h"

struct case_result {
    bool run; /* false: left out of this trial */
    struct attempt attempt;
};

struct check_result {
    enum verdict verdict;   /* PASSED, NOT_REACHED, NOT_MEASURED, or what it found */
    char cause[CAUSE_SLUG]; /* empty when it passed */
    struct message cause_name, message;
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
    STAGE_GROWTH,
    STAGE_COUNT
};

/* What to run. */
struct trial_scope {
    bool public_only;      /* only cases that students see */
    bool quick;            /* only quick cases; no check but leak */
    const char *only_case; /* NULL: all */
    int64_t *stage_cpu_ns; /* [STAGE_COUNT], gets the CPU time of each step; NULL: not wanted */
};

struct trial {
    struct yardstick *yardstick;
    const char *student; /* borrowed */
    const struct source *sources;
    int source_count;
    struct trial_scope scope;
    struct build build;
    struct case_result *cases; /* judge->case_count */
    struct check_result checks[CHECK_COUNT];
    struct family_result families[FAMILIES_MAX];
    double work_ratio, instruction_ratio, miss_ratio; /* worst family, largest size; 0: unknown */
    double memory_ratio;
    int memory_family;
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

/* Sets a check's verdict and both sentences (same arguments for both). The cause is copied; NULL
 * when the check passed. */
void check_say(struct check_result *check, enum verdict verdict, const struct cause *cause,
               const char *en, const char *es, ...)
    __attribute__((format(printf, 4, 6), format(printf, 5, 6)));

/* Something before it failed: a check or case was not looked at. */
extern const struct cause trial_not_reached;

/* -- the steps, one file each; all return 0, or -1 and *err: a fault ------------------------- */

/* cases.c: every case of the scope in a fresh box. */
int trial_run_cases(struct trial *trial, struct error *err) MUST_CHECK;
bool trial_case_in_scope(const struct judge_case *c, const struct trial_scope *scope);

/* Whether the first class of the exercise passed whole. */
bool trial_basic_class_passed(const struct trial *trial);

/* Whether a case that was run has no right answer. */
bool trial_any_case_failed(const struct trial *trial);

/* undefined.c: the cases again under ASan and UBSan, then under memcheck. */
int trial_check_undefined_behaviour(struct trial *trial, struct error *err) MUST_CHECK;

/* sweep.c: every allocation of some cases refused in turn. */
int trial_check_allocation_failure(struct trial *trial, struct error *err) MUST_CHECK;

/* growth.c: memory, growth and work on the sized inputs. */
int trial_check_growth(struct trial *trial, struct error *err) MUST_CHECK;

/* pace.c: the second witness of speed: is the charged CPU time of this submission above `bound`
 * times the reference's, by paired runs on the same CPU? Decided by a sequential sign test. */
int trial_is_slower(struct trial *trial, int family, int size_index, double bound, bool *slower,
                    struct error *err) MUST_CHECK;

/* The same question about a bound that no honest submission comes near, asked of every submission:
 * a lead of three pairs within it answers no. One pair would not do: beside other work a single run
 * of the reference is at times charged six times what the others are, and of nine pairs that is one
 * too often. The meshes are others than those that are counted.
 *
 * denied   gets whether the time is above the bound, or the submission did not answer
 * failure  gets a wrong answer to one of the first three meshes, or one whose verdict is
 *          VERDICT_PASSED; attempt_release must follow */
int trial_time_denies(struct trial *trial, int family, int size_index, double bound, bool *denied,
                      struct attempt *failure, struct error *err) MUST_CHECK;

#endif
