/* The second witness of speed: paired runs of submission and reference.
 *
 * Both wait in boxes of their own, pinned to one CPU together with the engine, so that their CPU
 * clocks are exact when the engine reads them. Each pair gets the same fresh mesh; all CPU charged
 * between two readings counts, whatever the program did meanwhile. */
#include "bench/measure/sign_test.h"
#include "graders/engine/series.h"
#include "graders/engine/trial.h"

#include <sched.h>
#include <string.h>

enum { WARM_UP_PAIRS = 3 };
static const struct call_limits limits = {30000000000LL, 5000000000LL};

static int make_fresh(const struct yardstick *yardstick, int family, int size_index, uint64_t seed,
                      struct input *input, struct error *err)
{
    struct writer writer = writer_growing();
    int result =
        yardstick->judge->make_sized(family, yardstick->sizes[size_index], seed, &writer, err);
    if (result == 0 && (writer.failed || writer.count > input->region.capacity))
        result = error_set(err, "judge %s: inputs of one size differ in bytes",
                           yardstick->judge->exercise);
    if (result == 0) {
        memcpy(input->region.bytes, writer.bytes, writer.count);
        input->bytes = writer.count;
    }
    writer_release(&writer);
    return result;
}

/* One pair. *ratio gets 0 when it cannot be used; *right says whether the submission answered. */
static int run_pair(struct series *reference, struct series *submission, const struct input *input,
                    double *ratio, bool *right, struct error *err)
{
    struct attempt theirs = {0}, mine = {0};
    *ratio = 0;
    *right = false;
    if (series_call(reference, input, 0, &limits, &theirs) != CALL_ANSWERED)
        return error_set(err, "the reference did not answer in a paired run");
    if (series_call(submission, input, 0, &limits, &mine) != CALL_ANSWERED)
        return 0;
    int result = attempt_judge(submission->yardstick, input, &submission->session, &mine, err);
    *right = result == 0 && mine.verdict == VERDICT_PASSED;
    if (theirs.cpu_ns > 0)
        *ratio = (double)mine.cpu_ns / (double)theirs.cpu_ns;
    attempt_release(&mine);
    return result;
}

static int run_pairs(struct trial *trial, int family, int size_index, struct series *reference,
                     struct series *submission, struct input *input, struct sign_test *test,
                     struct error *err)
{
    struct yardstick *yardstick = trial->yardstick;
    for (int pair = -WARM_UP_PAIRS; sign_test_decision(test) == SIGN_OPEN; pair++) {
        double ratio;
        bool right;
        if (make_fresh(yardstick, family, size_index,
                       yardstick->seed + 1000 + (uint64_t)(pair + WARM_UP_PAIRS), input,
                       err) != 0 ||
            run_pair(reference, submission, input, &ratio, &right, err) != 0)
            return -1;
        if (!right) {
            test->above = SIGN_TEST_LEAD + test->below; /* no credit for wrong answers */
            return 0;
        }
        if (pair >= 0)
            sign_test_add(test, ratio);
    }
    return 0;
}

int trial_is_slower(struct trial *trial, int family, int size_index, double bound, bool *slower,
                    struct error *err)
{
    struct yardstick *yardstick = trial->yardstick;
    struct series reference, submission;
    struct sign_test test = {.bound = bound};
    const struct input *sample;
    struct attempt ignored = {0};
    cpu_set_t before, here;
    if (yardstick_sized(yardstick, family, size_index, &sample, err) != 0)
        return -1;
    struct input fresh = {.answer_bound = sample->answer_bound};
    if (region_make(&fresh.region, sample->bytes, false, err) != 0)
        return -1;
    struct series_plan plan = {.yardstick = yardstick,
                               .build = &yardstick->reference,
                               .tool = SERIES_PLAIN,
                               .input_bytes = sample->bytes,
                               .answer_bytes = sample->answer_bound,
                               .cpu = sched_getcpu()};
    sched_getaffinity(0, sizeof before, &before);
    CPU_ZERO(&here);
    CPU_SET((size_t)plan.cpu, &here);
    sched_setaffinity(0, sizeof here, &here);
    int result = series_start(&reference, &plan, err);
    plan.build = &trial->build;
    int second = series_start(&submission, &plan, err);
    if (result == 0 && second == 0)
        result = run_pairs(trial, family, size_index, &reference, &submission, &fresh, &test, err);
    else
        result = -1;
    sched_setaffinity(0, sizeof before, &before);
    if (submission.started && series_end(&submission, &ignored, err) != 0)
        result = -1;
    series_release(&submission);
    series_release(&reference);
    region_release(&fresh.region);
    *slower = sign_test_decision(&test) == SIGN_ABOVE;
    return result;
}
