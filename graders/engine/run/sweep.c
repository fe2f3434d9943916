/* What does the function do when memory runs out? Some cases again, with one allocation after the
 * other refused, of many a sample: it must say so in the documented way (or do without), neither crash nor leak. */
#include "graders/engine/run/sweep.h"

#include "graders/engine/run/series.h"
#include "reference/base/plural.h"
#include "reference/base/random.h"

#include <string.h>

static const struct cause refused_allocation = {"allocation-failure",
                                                {"refused allocation", "reserva denegada"}};

enum { CASES_MAX = 4, INPUT_BYTES_MAX = 1 << 18 };
static const struct call_limits limits = {5000000000LL, 2000000000LL};

/* Chooses small cases with right answers that allocate, no two of the same class. */
static int choose_cases(const struct trial *trial, size_t chosen[CASES_MAX])
{
    const struct judge *judge = trial->yardstick->inputs.judge;
    int count = 0;
    for (size_t i = 0; i < judge->case_count && count < CASES_MAX; i++) {
        bool fits = trial->cases[i].run && attempt_is_right(&trial->cases[i].attempt) &&
                    trial->cases[i].attempt.claims.allocation_count > 0 &&
                    trial->yardstick->inputs.cases[i].bytes <= INPUT_BYTES_MAX;
        for (int k = 0; k < count && fits; k++)
            fits = strcmp(judge->cases[chosen[k]].class_name, judge->cases[i].class_name) != 0;
        if (fits)
            chosen[count++] = i;
    }
    return count;
}

/* What one refused allocation showed. Returns 0, or -1: a fault. */
static int judge_call(struct trial *trial, const struct series *series, size_t index,
                      long long failing, struct attempt *attempt, struct error *err)
{
    struct check_result *check = &trial->checks[CHECK_ALLOCATION_FAILURE];
    const char *name = trial->yardstick->inputs.judge->cases[index].name;
    const struct input *input = &trial->yardstick->inputs.cases[index];
    if (series->end != CALL_ANSWERED) {
        check_say(check, VERDICT_CRASH, &refused_allocation,
                  "In case %s your function crashes when allocation number %lld fails: test what "
                  "malloc returns.",
                  "En el caso %s tu función se interrumpe si falla la reserva número %lld: "
                  "comprueba lo que devuelve malloc.",
                  name, failing);
        return 0;
    }
    if (attempt->claims.leaked_blocks > 0) {
        check_say(check, VERDICT_LEAK, &refused_allocation,
                  "In case %s, when allocation number %lld fails, your function leaks %lld byte%s.",
                  "En el caso %s, si falla la reserva número %lld, tu función pierde %lld byte%s.",
                  name, failing, (long long)attempt->claims.heap_left_bytes,
                  plural_ending(attempt->claims.heap_left_bytes));
        return 0;
    }
    if (attempt->claims.out_of_memory)
        return 0;
    if (attempt_judge(&trial->yardstick->inputs, input, &series->session, attempt, err) != 0)
        return -1;
    if (attempt->verdict != VERDICT_PASSED)
        check_say(check, VERDICT_WRONG_ANSWER, &refused_allocation,
                  "In case %s, when allocation number %lld fails, your function neither reports it "
                  "nor gives the right answer.",
                  "En el caso %s, si falla la reserva número %lld, tu función ni avisa ni da la "
                  "respuesta correcta.",
                  name, failing);
    return 0;
}

int sweep_choose(int64_t allocations, uint64_t seed, int64_t chosen[SWEEP_MOST])
{
    struct random rng;
    const int64_t rest = allocations - SWEEP_FIRST;
    int count = 0;
    random_init(&rng, seed);
    const int first = allocations > SWEEP_MOST ? SWEEP_FIRST : (int)allocations;
    for (; count < first; count++)
        chosen[count] = count + 1;
    int parity = (int)random_below(&rng, 2);
    for (int part = 0; part < SWEEP_FIRST && allocations > SWEEP_MOST; part++) {
        int64_t low = SWEEP_FIRST + 1 + rest * part / SWEEP_FIRST;
        int64_t end = SWEEP_FIRST + 1 + rest * (part + 1) / SWEEP_FIRST;
        int64_t drawn = low + (int64_t)random_below(&rng, (uint64_t)(end - low));
        if (drawn % 2 != (part + parity) % 2)
            drawn = drawn + 1 < end ? drawn + 1 : drawn > low ? drawn - 1 : drawn;
        chosen[count++] = drawn;
    }
    return count;
}

static int sweep_case(struct trial *trial, size_t index, struct error *err)
{
    const struct input *input = &trial->yardstick->inputs.cases[index];
    int64_t allocations = trial->cases[index].attempt.claims.allocation_count;
    int64_t failing[SWEEP_MOST];
    int count = sweep_choose(allocations, trial->yardstick->inputs.seed + index, failing);
    struct series series;
    struct series_plan plan = {.inputs = &trial->yardstick->inputs,
                               .build = &trial->build,
                               .tool = SERIES_PLAIN,
                               .input_bytes = input->bytes,
                               .answer_bytes = input->answer_bound,
                               .cpu = -1};
    struct attempt last = {0};
    int result = series_start(&series, &plan, err);
    for (int i = 0; i < count && result == 0; i++) {
        struct attempt attempt = {0};
        series_call(&series, input, failing[i], &limits, &attempt);
        result = judge_call(trial, &series, index, failing[i], &attempt, err);
        attempt_release(&attempt);
        if (trial->checks[CHECK_ALLOCATION_FAILURE].verdict != VERDICT_PASSED)
            break;
    }
    if (series.started && series_end(&series, &last, err) != 0)
        result = -1;
    attempt_release(&last);
    series_release(&series);
    return result;
}

int sweep_check(struct trial *trial, struct error *err)
{
    size_t chosen[CASES_MAX];
    struct check_result *check = &trial->checks[CHECK_ALLOCATION_FAILURE];
    int count = choose_cases(trial, chosen);
    check_say(check, VERDICT_PASSED, NULL, "Every refused allocation was handled.",
              "Se trató cada reserva denegada.");
    for (int i = 0; i < count && check->verdict == VERDICT_PASSED; i++)
        if (sweep_case(trial, chosen[i], err) != 0)
            return -1;
    return 0;
}
