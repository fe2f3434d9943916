/* Makes inputs and measures the reference; see yardstick.h. */
#include "graders/engine/run/yardstick.h"

#include "graders/engine/base/files.h"
#include "graders/engine/run/attempt.h"
#include "graders/engine/run/count.h"
#include "graders/engine/run/soundness.h"
#include "graders/judges/table.h"
#include "reference/base/random.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EXTRA_DOUBLINGS = 2 /* when the first sizes leave the growth undecided */ };
static const uint64_t SIZED_SEED = 20260411;
static const struct call_limits reference_limits = {60000000000LL, 10000000000LL};

/* ------------------------------------------------------------------- seeds */

/* A seed that only the class's number leads to. */
static uint64_t mix_seed(uint64_t published, uint32_t class_seed)
{
    struct random rng;
    random_init(&rng, published ^ (uint64_t)class_seed << 32);
    return random_next(&rng);
}

/* The judge with its own copy of the cases, those that are not public under seeds of the class. */
static int seed_judge(struct yardstick *yardstick, const struct judge *judge, uint32_t class_seed,
                      struct error *err)
{
    yardstick->seeded_cases = calloc(judge->case_count, sizeof *yardstick->seeded_cases);
    if (!yardstick->seeded_cases)
        return error_set(err, "out of memory for %zu cases", judge->case_count);
    memcpy(yardstick->seeded_cases, judge->cases,
           judge->case_count * sizeof *yardstick->seeded_cases);
    yardstick->seed = SIZED_SEED;
    if (class_seed != SEED_PUBLISHED) {
        yardstick->seed = mix_seed(SIZED_SEED, class_seed);
        for (size_t i = 0; i < judge->case_count; i++)
            if (!judge_case_is_public(&judge->cases[i]))
                yardstick->seeded_cases[i].seed = mix_seed(judge->cases[i].seed, class_seed);
    }
    yardstick->class_seed = class_seed;
    yardstick->seeded = *judge;
    yardstick->seeded.cases = yardstick->seeded_cases;
    yardstick->judge = &yardstick->seeded;
    return 0;
}

/* ------------------------------------------------------------------ inputs */

/* Moves a written packet into sealed memory. */
static int seal_input(const struct judge *judge, struct writer *writer, struct input *input,
                      struct error *err)
{
    if (writer->failed)
        return error_set(err, "judge %s: out of memory for an input", judge->exercise);
    if (region_make(&input->region, writer->count, true, err) != 0)
        return -1;
    memcpy(input->region.bytes, writer->bytes, writer->count);
    input->bytes = writer->count;
    struct span packet = {input->region.bytes, input->bytes};
    input->answer_bound = judge_answer_bound(judge, packet);
    input->weight = judge_input_weight(judge, packet);
    return 0;
}

static int make_case(struct yardstick *yardstick, size_t index, struct error *err)
{
    const struct judge *judge = yardstick->judge;
    struct writer writer = writer_growing();
    int result = judge_make(judge, &judge->cases[index], yardstick->models, &writer, err);
    if (result == 0)
        result = seal_input(judge, &writer, &yardstick->cases[index], err);
    writer_release(&writer);
    return result;
}

/* Runs the reference on a case: it must be accepted, and its time sets the limit. */
static int run_reference(struct yardstick *yardstick, size_t index, struct error *err)
{
    struct attempt attempt;
    const struct judge_case *c = &yardstick->judge->cases[index];
    int result =
        attempt_run(yardstick, &yardstick->reference, index, &reference_limits, &attempt, err);
    if (result == 0 && attempt.verdict != VERDICT_PASSED)
        result = error_set(err, "exercise %s: the reference fails case %s: %s %s",
                           yardstick->exercise->name, c->name, attempt.cause, attempt.message.en);
    yardstick->reference_cpu_ns[index] = attempt.cpu_ns > 0 ? attempt.cpu_ns : 1;
    attempt_release(&attempt);
    return result;
}

int yardstick_case(struct yardstick *yardstick, size_t index, const struct input **input,
                   struct error *err)
{
    if (yardstick->cases[index].bytes == 0 && make_case(yardstick, index, err) != 0)
        return -1;
    if (yardstick->reference_cpu_ns[index] == 0 && run_reference(yardstick, index, err) != 0)
        return -1;
    *input = &yardstick->cases[index];
    return 0;
}

int yardstick_make_cases(struct yardstick *yardstick, bool public_only, struct error *err)
{
    const struct input *input;
    for (size_t i = 0; i < yardstick->judge->case_count; i++)
        if ((judge_case_is_public(&yardstick->judge->cases[i]) || !public_only) &&
            yardstick_case(yardstick, i, &input, err) != 0)
            return -1;
    return 0;
}

int yardstick_sized(struct yardstick *yardstick, int family, int size_index,
                    const struct input **input, struct error *err)
{
    struct input *made = &yardstick->sized[family][size_index];
    *input = made;
    if (made->bytes != 0)
        return 0;
    struct writer writer = writer_growing();
    int result = judge_make_sized(yardstick->judge, family, yardstick->sizes[size_index],
                                  yardstick->seed, &writer, err);
    if (result == 0)
        result = seal_input(yardstick->judge, &writer, made, err);
    writer_release(&writer);
    return result;
}

int64_t yardstick_cpu_limit_ns(const struct yardstick *yardstick, size_t index)
{
    int64_t multiple = yardstick->reference_cpu_ns[index] * CPU_LIMIT_MULTIPLE;
    int64_t least = CPU_LIMIT_LEAST_SECONDS * INT64_C(1000000000);
    return multiple > least ? multiple : least;
}

/* --------------------------------------------------------------- reference */

static int build_reference(struct yardstick *yardstick, struct error *err)
{
    const struct exercise *exercise = yardstick->exercise;
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

/* The sizes at which growth is counted, and the two doublings that may be added. */
static void choose_sizes(struct yardstick *yardstick)
{
    const struct exercise *exercise = yardstick->exercise;
    if (!exercise->checked[CHECK_GROWTH])
        return;
    yardstick->family_count = judge_family_count(yardstick->judge);
    yardstick->size_count = exercise->growth_doublings + 1;
    for (int i = 0; i < yardstick->size_count + EXTRA_DOUBLINGS; i++)
        yardstick->sizes[i] = exercise->growth_first_size << i;
}

static int explain_failure(const struct yardstick *yardstick, const struct count_run *run,
                           struct error *err)
{
    return error_set(err, "exercise %s: the reference fails on %s: %s %s",
                     yardstick->exercise->name, judge_family_name(yardstick->judge, run->family),
                     run->failure.cause, run->failure.message.en);
}

static int count_reference(struct yardstick *yardstick, const struct count_plan *plan,
                           struct cost *const costs[FAMILIES_MAX], struct error *err)
{
    struct count_run run;
    int result = count_work(yardstick, &yardstick->reference, plan, costs, &run, err);
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
    int last_family = yardstick->family_count - 1;
    int result = 0;
    for (int family = 0; family <= last_family; family++)
        costs[family] = yardstick->costs[family];
    for (int family = 0; family <= last_family && result == 0; family++) {
        struct count_plan plan = {
            .first_family = family, .last_family = family, .last = yardstick->size_count - 1};
        result = count_memory(yardstick, &yardstick->reference, &plan, costs, &run, err);
        if (result == 0 && run.failure.verdict != VERDICT_PASSED)
            result = explain_failure(yardstick, &run, err);
        attempt_release(&run.failure);
    }
    if (result != 0 || last_family < 0 || !yardstick->probes.valgrind)
        return result;
    struct count_plan plan = {
        .last_family = last_family, .last = yardstick->size_count - 1, .leaps = true};
    if (count_reference(yardstick, &plan, costs, err) != 0)
        return -1;
    int gap = yardstick->size_count;
    for (int family = 0; family <= last_family; family++)
        for (int i = 0; i < gap; i++)
            if (!costs[family][i].counted)
                gap = i;
    plan = (struct count_plan){.last_family = last_family,
                               .first = gap,
                               .last = yardstick->size_count - 2,
                               .without_misses = true};
    return plan.first <= plan.last ? count_reference(yardstick, &plan, costs, err) : 0;
}

/* -------------------------------------------------------------------- life */

static int allocate(struct yardstick *yardstick, struct error *err)
{
    size_t count = yardstick->judge->case_count;
    yardstick->cases = calloc(count, sizeof *yardstick->cases);
    yardstick->reference_cpu_ns = calloc(count, sizeof *yardstick->reference_cpu_ns);
    if (!yardstick->cases || !yardstick->reference_cpu_ns)
        return error_set(err, "out of memory for %zu cases", count);
    for (size_t i = 0; i < count; i++)
        yardstick->cases[i].region.fd = -1;
    return 0;
}

int yardstick_make(struct yardstick *yardstick, const struct exercise *exercise,
                   uint32_t class_seed, bool quick, struct error *err)
{
    memset(yardstick, 0, sizeof *yardstick);
    build_clear(&yardstick->reference);
    for (int family = 0; family < FAMILIES_MAX; family++)
        for (int i = 0; i < SIZES_MAX; i++)
            yardstick->sized[family][i].region.fd = -1;
    yardstick->exercise = exercise;
    yardstick->quick = quick;
    const struct judge *judge = judge_find(exercise->name);
    if (soundness_check(exercise, judge, err) != 0)
        return -1;
    const char *root = project_root(err);
    if (!root || seed_judge(yardstick, judge, class_seed, err) != 0 ||
        allocate(yardstick, err) != 0 || build_reference(yardstick, err) != 0)
        return -1;
    snprintf(yardstick->models, sizeof yardstick->models, "%s/exercises/models", root);
    yardstick->probes.valgrind = count_available(&yardstick->probes.no_valgrind);
    choose_sizes(yardstick);
    return quick ? 0 : measure_reference(yardstick, err);
}

void yardstick_release(struct yardstick *yardstick)
{
    size_t count = yardstick->cases ? yardstick->judge->case_count : 0;
    for (size_t i = 0; i < count; i++)
        region_release(&yardstick->cases[i].region);
    for (int family = 0; family < FAMILIES_MAX; family++)
        for (int i = 0; i < SIZES_MAX; i++)
            region_release(&yardstick->sized[family][i].region);
    free(yardstick->cases);
    free(yardstick->reference_cpu_ns);
    free(yardstick->seeded_cases);
    build_release(&yardstick->reference);
    memset(yardstick, 0, sizeof *yardstick);
    build_clear(&yardstick->reference);
}
