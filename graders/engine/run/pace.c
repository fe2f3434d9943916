/* The second witness of speed; see pace.h. It decides marks
 * for speed together with the counts, and catches false counts, which come from the submission's
 * own process. */
#include "graders/engine/run/pace.h"

#include "bench/measure/sign_test.h"
#include "reference/base/random.h"

#include <string.h>

enum { WARM_UP_PAIRS = 3, WITHIN_LEAD = 3 };
static const struct call_limits limits = {30000000000LL, 5000000000LL};

/* ------------------------------------------------------------------- pairs */

/* Meshes of their own for each family, the same at each grading of the class. */
static uint64_t first_seed(const struct yardstick *yardstick, int family)
{
    struct random rng;
    random_init(&rng, yardstick->inputs.seed + 1 + (uint64_t)family);
    return random_next(&rng);
}

static int make_fresh(struct pace *pace, struct error *err)
{
    const struct yardstick *yardstick = pace->trial->yardstick;
    struct input *input = &pace->fresh;
    struct writer writer = writer_growing();
    int result = judge_make_sized(yardstick->inputs.judge, pace->family,
                                  yardstick->inputs.sizes[pace->family][pace->size_index],
                                  pace->seed + pace->pairs, &writer, err);
    if (result == 0 && (writer.failed || writer.count > input->region.capacity))
        result = error_set(err, "judge %s: inputs of one size differ in bytes",
                           yardstick->inputs.judge->exercise);
    if (result == 0) {
        memcpy(input->region.bytes, writer.bytes, writer.count);
        input->bytes = writer.count;
    }
    writer_release(&writer);
    return result;
}

int pace_pair(struct pace *pace, double *ratio, struct error *err)
{
    struct attempt theirs = {0}, mine = {0};
    *ratio = 0;
    pace->right = false;
    if (make_fresh(pace, err) != 0)
        return -1;
    pace->pairs++;
    if (series_call(&pace->reference, &pace->fresh, 0, &limits, &theirs) != CALL_ANSWERED)
        return error_set(err, "the reference did not answer in a paired run");
    enum call_end end = series_call(&pace->submission, &pace->fresh, 0, &limits, &mine);
    pace->gone = end != CALL_ANSWERED;
    pace->spent = end == CALL_SPENT;
    if (pace->gone)
        return 0;
    int result = attempt_judge(&pace->trial->yardstick->inputs, &pace->fresh,
                               &pace->submission.session, &mine, err);
    pace->right = result == 0 && mine.verdict == VERDICT_PASSED;
    if (theirs.cpu_ns > 0)
        *ratio = (double)mine.cpu_ns / (double)theirs.cpu_ns;
    if (result == 0 && !pace->right && pace->failure.verdict == VERDICT_PASSED)
        pace->failure = mine;
    else
        attempt_release(&mine);
    return result;
}

/* ----------------------------------------------------------- start and end */

static void pin(int cpu)
{
    cpu_set_t here;
    CPU_ZERO(&here);
    CPU_SET((size_t)cpu, &here);
    sched_setaffinity(0, sizeof here, &here);
}

static int start_both(struct pace *pace, const struct input *sample, struct error *err)
{
    struct trial *trial = pace->trial;
    struct series_plan plan = {.inputs = &trial->yardstick->inputs,
                               .build = &trial->yardstick->reference,
                               .tool = SERIES_PLAIN,
                               .input_bytes = sample->bytes,
                               .answer_bytes = sample->answer_bound,
                               .cpu = sched_getcpu()};
    pin(plan.cpu);
    if (series_start(&pace->reference, &plan, err) != 0)
        return -1;
    plan.build = &trial->build;
    return series_start(&pace->submission, &plan, err);
}

int pace_size_index(const struct yardstick *yardstick)
{
    int index = 0;
    while (index + 1 < SIZES_MAX && yardstick->inputs.told_sizes[index + 1] > 0)
        index++;
    return index;
}

int pace_start(struct pace *pace, struct trial *trial, int family, int size_index,
               struct error *err)
{
    const struct input *sample;
    *pace = (struct pace){.trial = trial,
                          .family = family,
                          .size_index = size_index,
                          .seed = first_seed(trial->yardstick, family),
                          .failure = {.verdict = VERDICT_PASSED},
                          .reference = series_none(),
                          .submission = series_none(),
                          .fresh = {.region = {.fd = -1}}};
    sched_getaffinity(0, sizeof pace->before, &pace->before);
    if (inputs_sized(&trial->yardstick->inputs, family, size_index, &sample, err) != 0)
        return -1;
    pace->fresh.answer_bound = sample->answer_bound;
    if (region_make(&pace->fresh.region, sample->bytes, false, err) != 0 ||
        start_both(pace, sample, err) != 0)
        return -1;
    for (int i = 0; i < WARM_UP_PAIRS && !pace->gone; i++) {
        double ignored;
        if (pace_pair(pace, &ignored, err) != 0)
            return -1;
    }
    return 0;
}

int pace_end(struct pace *pace, struct error *err)
{
    struct attempt ignored = {0};
    int result = 0;
    sched_setaffinity(0, sizeof pace->before, &pace->before);
    if (pace->submission.started)
        result = series_end(&pace->submission, &ignored, err);
    series_release(&pace->submission);
    series_release(&pace->reference);
    region_release(&pace->fresh.region);
    attempt_release(&pace->failure);
    return result;
}

/* ---------------------------------------------------------------- decision */

/* One pair for the test. A wrong answer, however fast, counts as slow: no credit for it. */
static int add_pair(struct pace *pace, struct sign_test *test, struct error *err)
{
    double ratio;
    if (pace_pair(pace, &ratio, err) != 0)
        return -1;
    if (!pace->gone)
        sign_test_add(test, pace->right ? ratio : 2 * test->bound);
    return 0;
}

int pace_is_slower(struct trial *trial, int family, int size_index, double bound, bool *slower,
                   struct error *err)
{
    struct sign_test test = {.bound = bound};
    struct pace pace;
    int result = pace_start(&pace, trial, family, size_index, err);
    while (result == 0 && !pace.gone && sign_test_decision(&test) == SIGN_OPEN)
        result = add_pair(&pace, &test, err);
    *slower = (pace.gone && !pace.spent) || sign_test_decision(&test) == SIGN_ABOVE;
    return pace_end(&pace, err) != 0 ? -1 : result;
}

int pace_time_denies(struct trial *trial, int family, int size_index, double bound, bool *denied,
                     struct attempt *failure, struct error *err)
{
    struct sign_test test = {.bound = bound};
    struct pace pace;
    int result = pace_start(&pace, trial, family, size_index, err);
    *failure = pace.failure;
    pace.failure = (struct attempt){.verdict = VERDICT_PASSED};
    if (result == 0 && failure->verdict == VERDICT_PASSED)
        while (result == 0 && !pace.gone && test.below - test.above < WITHIN_LEAD &&
               sign_test_decision(&test) == SIGN_OPEN)
            result = add_pair(&pace, &test, err);
    *denied = (pace.gone && !pace.spent) || sign_test_decision(&test) == SIGN_ABOVE;
    return pace_end(&pace, err) != 0 ? -1 : result;
}
