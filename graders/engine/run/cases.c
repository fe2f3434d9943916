/* The cases of a trial; see cases.h. */
#include "graders/engine/run/cases.h"

#include <stdio.h>
#include <string.h>

enum {
    TIME_LIMITS_TO_STOP = 2,
    CONFIRMING_MULTIPLE = 3 /* what the repeated run of a case may take, in limits */
};
static const int64_t IDLE_LIMIT_NS = 2000000000;

bool cases_in_scope(const struct judge_case *c, const struct trial_scope *scope)
{
    if (scope->only_case)
        return strcmp(c->name, scope->only_case) == 0;
    return (!scope->public_only || judge_case_is_public(c)) &&
           (!scope->quick || judge_case_is_quick(c));
}

static bool is_time_limit(enum verdict verdict)
{
    return verdict == VERDICT_CPU_TIME || verdict == VERDICT_IDLE_TIME;
}

/* One run of a case with `multiple` times its limit of CPU time. */
static int run_once(struct trial *trial, size_t index, int multiple, struct attempt *attempt,
                    struct error *err)
{
    struct call_limits limits = {multiple * yardstick_cpu_limit_ns(trial->yardstick, index),
                                 IDLE_LIMIT_NS};
    return attempt_run(&trial->yardstick->inputs, &trial->build, index, &limits, attempt, err);
}

/* The limit as its rule: seconds were measured, and would differ between runs. */
static void explain_cpu_limit(struct attempt *attempt)
{
    int multiple = CONFIRMING_MULTIPLE * CPU_LIMIT_MULTIPLE;
    int least_seconds = CONFIRMING_MULTIPLE * CPU_LIMIT_LEAST_SECONDS;
    attempt_say(attempt, VERDICT_CPU_TIME, &attempt_cpu_limit,
                "Your function takes more than %d times the CPU time of the reference (and more "
                "than %d s). It is a loop without end, or far too much work.",
                "Tu función tarda más de %d veces el tiempo de CPU de la referencia (y más de %d "
                "s). Es un bucle sin fin o demasiado trabajo.",
                multiple, least_seconds);
}

/* A limit of time counts only when a fresh process breaks it again, with a multiple of the time: a
 * slow but finite answer near the limit would otherwise get its verdict from the noise of the
 * machine. After the first limit that counts (`patient`) the short run is left out. */
static int run_case(struct trial *trial, size_t index, bool patient, struct attempt *attempt,
                    struct error *err)
{
    const struct input *input;
    if (yardstick_case(trial->yardstick, index, &input, err) != 0)
        return -1;
    if (!patient) {
        if (run_once(trial, index, 1, attempt, err) != 0)
            return -1;
        if (!is_time_limit(attempt->verdict))
            return 0;
        attempt_release(attempt);
    }
    int result = run_once(trial, index, CONFIRMING_MULTIPLE, attempt, err);
    if (result == 0 && strcmp(attempt->cause, attempt_cpu_limit.slug) == 0)
        explain_cpu_limit(attempt);
    return result;
}

static void remember_surroundings(struct trial *trial, const struct attempt *attempt)
{
    trial->active_layers = attempt->outcome.active;
    memcpy(trial->layer_reasons, attempt->outcome.reason, sizeof trial->layer_reasons);
    if (!trial->output[0])
        snprintf(trial->output, sizeof trial->output, "%s", attempt->output);
}

int cases_run(struct trial *trial, struct error *err)
{
    const struct judge *judge = trial->yardstick->inputs.judge;
    int time_limits = 0;
    for (size_t i = 0; i < judge->case_count; i++) {
        struct attempt *attempt = &trial->cases[i].attempt;
        if (!cases_in_scope(&judge->cases[i], &trial->scope))
            continue;
        trial->cases[i].run = true;
        if (time_limits >= TIME_LIMITS_TO_STOP) {
            attempt_say(attempt, VERDICT_NOT_REACHED, &check_not_reached,
                        "Not run: %d cases before it did not end in time.",
                        "No se ejecutó: %d casos anteriores no terminaron a tiempo.", time_limits);
            continue;
        }
        if (run_case(trial, i, time_limits > 0, attempt, err) != 0)
            return -1;
        time_limits += is_time_limit(attempt->verdict);
        remember_surroundings(trial, attempt);
    }
    return 0;
}

bool cases_basic_class_passed(const struct trial *trial)
{
    const struct judge *judge = trial->yardstick->inputs.judge;
    const char *basic = trial->yardstick->inputs.exercise->classes[0].name;
    bool any = false;
    for (size_t i = 0; i < judge->case_count; i++) {
        if (!trial->cases[i].run || strcmp(judge->cases[i].class_name, basic) != 0)
            continue;
        if (trial->cases[i].attempt.verdict != VERDICT_PASSED)
            return false;
        any = true;
    }
    return any;
}

bool cases_any_failed(const struct trial *trial)
{
    for (size_t i = 0; i < trial->yardstick->inputs.judge->case_count; i++)
        if (trial->cases[i].run && !attempt_is_right(&trial->cases[i].attempt))
            return true;
    return false;
}
