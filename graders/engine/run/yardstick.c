/* Measures the reference; see yardstick.h. */
#include "graders/engine/run/yardstick.h"

#include "graders/engine/base/files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct call_limits reference_limits = {60000000000LL, 10000000000LL};

/* Runs the reference on a case: it must be accepted, and its time sets the limit. */
static int run_reference(struct yardstick *yardstick, size_t index, struct error *err)
{
    struct attempt attempt;
    const struct judge_case *c = &yardstick->inputs.judge->cases[index];
    int result = attempt_run(&yardstick->inputs, &yardstick->reference, index, &reference_limits,
                             &attempt, err);
    if (result == 0 && attempt.verdict != VERDICT_PASSED)
        result =
            error_set(err, "exercise %s: the reference fails case %s: %s %s",
                      yardstick->inputs.exercise->name, c->name, attempt.cause, attempt.message.en);
    yardstick->reference_cpu_ns[index] = attempt.cpu_ns > 0 ? attempt.cpu_ns : 1;
    attempt_release(&attempt);
    return result;
}

int yardstick_case(struct yardstick *yardstick, size_t index, const struct input **input,
                   struct error *err)
{
    if (inputs_case(&yardstick->inputs, index, input, err) != 0)
        return -1;
    return yardstick->reference_cpu_ns[index] != 0 ? 0 : run_reference(yardstick, index, err);
}

int yardstick_make_cases(struct yardstick *yardstick, bool public_only, struct error *err)
{
    const struct input *input;
    for (size_t i = 0; i < yardstick->inputs.judge->case_count; i++)
        if ((judge_case_is_public(&yardstick->inputs.judge->cases[i]) || !public_only) &&
            yardstick_case(yardstick, i, &input, err) != 0)
            return -1;
    return 0;
}

int64_t yardstick_cpu_limit_ns(const struct yardstick *yardstick, size_t index)
{
    int64_t multiple = yardstick->reference_cpu_ns[index] * CPU_LIMIT_MULTIPLE;
    int64_t least = CPU_LIMIT_LEAST_SECONDS * INT64_C(1000000000);
    return multiple > least ? multiple : least;
}

static int build_reference(struct yardstick *yardstick, struct error *err)
{
    const struct exercise *exercise = yardstick->inputs.exercise;
    const char *root = project_root(err);
    char path[PATH_MAX], *text;
    size_t count;
    if (!root)
        return -1;
    snprintf(path, sizeof path, "%s/reference/answers/%s/%s.c", root, exercise->group,
             exercise->name);
    if (file_read(path, 1 << 20, &text, &count, err) != 0)
        return -1;
    struct source source = {"answer.c", text, count};
    int result = build_submission(exercise, &source, 1, BUILD_PLAIN, &yardstick->reference, err);
    free(text);
    if (result == 0 && yardstick->reference.refusal.refused)
        result = error_set(
            err, "%s does not build: %s: %s %.200s", path, yardstick->reference.refusal.cause,
            yardstick->reference.refusal.message.en, yardstick->reference.diagnostics);
    return result;
}

static int explain_failure(const struct yardstick *yardstick, const struct count_run *run,
                           struct error *err)
{
    return error_set(err, "exercise %s: the reference fails on %s: %s %s",
                     yardstick->inputs.exercise->name,
                     judge_family_name(yardstick->inputs.judge, run->family), run->failure.cause,
                     run->failure.message.en);
}

static int count_reference(struct yardstick *yardstick, const struct count_plan *plan,
                           struct cost *const costs[FAMILIES_MAX], struct error *err)
{
    struct count_run run;
    int result = count_work(&yardstick->inputs, &yardstick->reference, plan, costs, &run, err);
    if (result == 0 && run.failure.verdict != VERDICT_PASSED)
        result = explain_failure(yardstick, &run, err);
    attempt_release(&run.failure);
    return result;
}

/* At every size: those that submissions leap over are counted without misses. */
static int measure_reference(struct yardstick *yardstick, struct error *err)
{
    struct cost *costs[FAMILIES_MAX];
    struct count_run run;
    int last_family = yardstick->inputs.family_count - 1;
    int result = 0;
    for (int family = 0; family <= last_family; family++)
        costs[family] = yardstick->costs[family];
    for (int family = 0; family <= last_family && result == 0; family++) {
        struct count_plan plan = {.first_family = family,
                                  .last_family = family,
                                  .last = inputs_beyond(&yardstick->inputs)};
        result = count_memory(&yardstick->inputs, &yardstick->reference, &plan, costs, &run, err);
        if (result == 0 && run.failure.verdict != VERDICT_PASSED)
            result = explain_failure(yardstick, &run, err);
        attempt_release(&run.failure);
    }
    if (result != 0 || last_family < 0 || !yardstick->probes.valgrind)
        return result;
    struct count_plan plan = {
        .last_family = last_family, .last = yardstick->inputs.size_count - 1, .leaps = true};
    if (count_reference(yardstick, &plan, costs, err) != 0)
        return -1;
    int gap = yardstick->inputs.size_count;
    for (int family = 0; family <= last_family; family++)
        for (int i = 0; i < gap; i++)
            if (!costs[family][i].counted)
                gap = i;
    plan = (struct count_plan){.last_family = last_family,
                               .first = gap,
                               .last = yardstick->inputs.size_count - 2,
                               .without_misses = true};
    return plan.first <= plan.last ? count_reference(yardstick, &plan, costs, err) : 0;
}

/* -------------------------------------------------------------------- life */

int yardstick_make(struct yardstick *yardstick, const struct exercise *exercise, struct seeds seeds,
                   bool quick, struct error *err)
{
    memset(yardstick, 0, sizeof *yardstick);
    build_clear(&yardstick->reference);
    yardstick->quick = quick;
    if (inputs_prepare(&yardstick->inputs, exercise, seeds, err) != 0)
        return -1;
    size_t count = yardstick->inputs.judge->case_count;
    yardstick->reference_cpu_ns = calloc(count, sizeof *yardstick->reference_cpu_ns);
    if (!yardstick->reference_cpu_ns)
        return error_set(err, "out of memory for %zu cases", count);
    if (build_reference(yardstick, err) != 0)
        return -1;
    yardstick->probes.valgrind = count_available(&yardstick->probes.no_valgrind);
    return quick ? 0 : measure_reference(yardstick, err);
}

void yardstick_release(struct yardstick *yardstick)
{
    inputs_release(&yardstick->inputs);
    free(yardstick->reference_cpu_ns);
    build_release(&yardstick->reference);
    memset(yardstick, 0, sizeof *yardstick);
    build_clear(&yardstick->reference);
}
