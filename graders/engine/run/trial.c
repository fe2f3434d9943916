/* The life of one submission after upload: build, cases, checks; see trial.h. */
#include "graders/engine/run/trial.h"

#include "graders/engine/run/cases.h"
#include "graders/engine/run/sized.h"
#include "graders/engine/run/sweep.h"
#include "graders/engine/run/undefined.h"
#include "reference/base/plural.h"

#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

/* Leaks need no run of their own: the shim saw every case. The smallest leaking case speaks. */
static void check_leak(struct trial *trial)
{
    const struct judge *judge = trial->yardstick->inputs.judge;
    struct check_result *check = &trial->checks[CHECK_LEAK];
    check_say(check, VERDICT_PASSED, NULL, "Everything allocated is freed or returned.",
              "Todo lo reservado se libera o se devuelve.");
    const struct control *least = NULL;
    for (size_t i = 0; i < judge->case_count; i++) {
        const struct control *claims = &trial->cases[i].attempt.claims;
        if (!trial->cases[i].run || claims->phase != PHASE_DONE || claims->leaked_blocks <= 0 ||
            (least && claims->heap_left_bytes >= least->heap_left_bytes))
            continue;
        least = claims;
        check_say(
            check, VERDICT_LEAK, &check_leaked_blocks,
            "In case %s your function leaves %lld byte%s in %lld block%s that nobody can free "
            "any more.",
            "En el caso %s tu función deja %lld byte%s en %lld bloque%s que ya nadie puede "
            "liberar.",
            judge->cases[i].name, (long long)claims->heap_left_bytes,
            plural_ending(claims->heap_left_bytes), (long long)claims->leaked_blocks,
            plural_ending(claims->leaked_blocks));
    }
}

/* CPU time of this process and all that it has reaped, boxes included. */
static int64_t spent_ns(void)
{
    static const int whose[] = {RUSAGE_SELF, RUSAGE_CHILDREN};
    int64_t spent = 0;
    for (int i = 0; i < 2; i++) {
        struct rusage usage;
        getrusage(whose[i], &usage);
        spent += (usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) * 1000000000LL +
                 (usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) * 1000LL;
    }
    return spent;
}

static void charge(const struct trial *trial, enum trial_stage stage, int64_t *since_ns)
{
    int64_t now = spent_ns();
    if (trial->scope.stage_cpu_ns)
        trial->scope.stage_cpu_ns[stage] += now - *since_ns;
    *since_ns = now;
}

static void set_not_reached(struct trial *trial)
{
    for (int check = 0; check < CHECK_COUNT; check++)
        check_say(&trial->checks[check], VERDICT_NOT_REACHED, &check_not_reached,
                  "Not looked at, because something before it failed.",
                  "No se examinó, porque falló algo anterior.");
}

/* Counts repeat as long as the program does the same again. Where it may not, the report says so: a
 * mark near a limit may then differ from one grading to the next. */
static void tell_chance(struct trial *trial)
{
    static const enum check_kind counted[] = {CHECK_GROWTH, CHECK_QUERY_GROWTH, CHECK_WORK,
                                              CHECK_QUERY_WORK};
    const char *function = trial->build.chance;
    for (size_t i = 0; function[0] && i < sizeof counted / sizeof *counted; i++)
        if (trial->checks[counted[i]].verdict != VERDICT_NOT_REACHED)
            message_add(&trial->checks[counted[i]].message,
                        " The program calls %s, so it may do something else in every run and these "
                        "counts may differ from run to run.",
                        " El programa llama a %s, así que puede hacer algo distinto en cada "
                        "ejecución y estas cuentas pueden variar de una a otra.",
                        function);
}

/* Whether the scope and the exercise have the step that `check` stands for. */
static bool has_step(const struct trial *trial, enum trial_stage stage, enum check_kind check)
{
    return !(trial->scope.left_out & 1u << stage) &&
           trial->yardstick->inputs.exercise->checked[check];
}

/* When the budget ran out while the checks from `first` to `last` were made: what they found by
 * that says nothing but that. What is for a person to look at stays so. */
static bool ran_out(struct trial *trial, enum check_kind first, enum check_kind last)
{
    if (!budget_is_spent(&trial->budget, 0))
        return false;
    for (int check = (int)first; check <= (int)last; check++)
        if (trial->checks[check].verdict != VERDICT_PASSED &&
            trial->checks[check].verdict != VERDICT_FLAGGED)
            check_say(&trial->checks[check], VERDICT_CPU_TIME, &attempt_budget_spent,
                      ATTEMPT_SPENT_EN, ATTEMPT_SPENT_ES, BUDGET_SECONDS);
    return true;
}

static int run_checks(struct trial *trial, struct error *err)
{
    int64_t since_ns = spent_ns();
    if (has_step(trial, STAGE_UNDEFINED_BEHAVIOUR, CHECK_UNDEFINED_BEHAVIOUR) &&
        undefined_check(trial, err) != 0)
        return -1;
    charge(trial, STAGE_UNDEFINED_BEHAVIOUR, &since_ns);
    if (ran_out(trial, CHECK_UNDEFINED_BEHAVIOUR, CHECK_UNDEFINED_BEHAVIOUR) ||
        !cases_basic_class_passed(trial))
        return 0;
    if (has_step(trial, STAGE_ALLOCATION_FAILURE, CHECK_ALLOCATION_FAILURE) &&
        sweep_check(trial, err) != 0)
        return -1;
    charge(trial, STAGE_ALLOCATION_FAILURE, &since_ns);
    if (ran_out(trial, CHECK_ALLOCATION_FAILURE, CHECK_ALLOCATION_FAILURE))
        return 0;
    bool right = true;
    if (has_step(trial, STAGE_MEMORY, CHECK_GROWTH) && sized_check_memory(trial, &right, err) != 0)
        return -1;
    charge(trial, STAGE_MEMORY, &since_ns);
    if (ran_out(trial, CHECK_GROWTH, CHECK_QUERY_MEMORY))
        return 0;
    if (right && has_step(trial, STAGE_GROWTH, CHECK_GROWTH) && sized_check_growth(trial, err) != 0)
        return -1;
    charge(trial, STAGE_GROWTH, &since_ns);
    (void)ran_out(trial, CHECK_GROWTH, CHECK_QUERY_MEMORY);
    tell_chance(trial);
    return 0;
}

int trial_run(struct trial *trial, struct yardstick *yardstick, const char *student,
              const struct source *sources, int source_count, const struct trial_scope *scope,
              struct error *err)
{
    memset(trial, 0, sizeof *trial);
    build_clear(&trial->build);
    trial->yardstick = yardstick;
    trial->student = student;
    trial->sources = sources;
    trial->source_count = source_count;
    trial->scope = *scope;
    set_not_reached(trial);
    trial->cases = calloc(yardstick->inputs.judge->case_count, sizeof *trial->cases);
    if (!trial->cases)
        return error_set(err, "out of memory");
    int64_t since_ns = spent_ns();
    bool only_cases = scope->quick || scope->only_case;
    bool plain = only_cases || scope->left_out & 1u << STAGE_UNDEFINED_BEHAVIOUR;
    if (build_submission(yardstick->inputs.exercise, sources, source_count,
                         plain ? BUILD_PLAIN : BUILD_ALL, &trial->build, err) != 0)
        return -1;
    charge(trial, STAGE_BUILD, &since_ns);
    trial->budget.limit_ns = (scope->budget_ns ? scope->budget_ns : BUDGET_SECONDS * 1000000000LL);
    trial->build.budget = &trial->budget;
    trial->active_layers = trial->build.active_layers;
    if (trial->build.refusal.refused)
        return 0;
    if (cases_run(trial, err) != 0)
        return -1;
    charge(trial, STAGE_CASES, &since_ns);
    check_leak(trial);
    return only_cases || budget_is_spent(&trial->budget, 0) ? 0 : run_checks(trial, err);
}

void trial_release(struct trial *trial)
{
    for (size_t i = 0; trial->cases && i < trial->yardstick->inputs.judge->case_count; i++)
        attempt_release(&trial->cases[i].attempt);
    free(trial->cases);
    trial->cases = NULL;
    build_release(&trial->build);
}
