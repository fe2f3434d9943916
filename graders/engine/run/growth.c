/* The checks that rest on sized inputs: growth of the work, amount of work, peak of memory. */
#include "graders/engine/run/pace.h"

#include <stdio.h>
#include <string.h>

static const struct cause memory_outside_heap = {
    "memory-outside-heap", {"memory outside malloc", "memoria fuera de malloc"}};
static const struct cause memory_band = {
    "memory-band", {"memory above the band", "memoria por encima del margen"}};
static const struct cause work_band = {"work-band",
                                       {"work above the band", "trabajo por encima del margen"}};
static const struct cause time_denies_counts = {
    "time-denies-counts", {"time contradicts the counts", "el tiempo contradice las cuentas"}};
static const struct cause no_valgrind = {"no-valgrind", {"no valgrind", "sin valgrind"}};

enum {
    MEMORY_FLOOR_BYTES = 4096, /* so that a reference that allocates nothing can be divided by */
    EXTRA_DOUBLINGS = 2,
    TIME_FLOOR = 30,  /* see check_counts */
    TIME_TO_COUNT = 5 /* see check_counts */
};

static const enum check_kind sized_checks[] = {CHECK_GROWTH, CHECK_WORK, CHECK_MEMORY};
enum { SIZED_CHECKS = sizeof sized_checks / sizeof sized_checks[0] };

/* --------------------------------------------------------------- measuring */

/* A call on a sized input went wrong: no check that rests on it can pass. It is a failure of its
 * own only when every case was right; otherwise the cases tell the mistake, and better. */
static void blame_failure(struct trial *trial, int family, int size_index,
                          const struct attempt *failure)
{
    const struct yardstick *yardstick = trial->yardstick;
    enum verdict verdict = trial_any_case_failed(trial) ? VERDICT_NOT_REACHED : failure->verdict;
    const struct cause cause = attempt_cause(failure);
    for (int i = 0; i < SIZED_CHECKS; i++) {
        struct check_result *check = &trial->checks[sized_checks[i]];
        check_say(check, verdict, &cause, "With the input %s of size %lld: ",
                  "Con la entrada %s de tamaño %lld: ", judge_family_name(yardstick->judge, family),
                  (long long)yardstick->sizes[size_index]);
        message_add_phrase(&check->message, message_phrase(&failure->message));
    }
}

static int measure_memory(struct trial *trial, int family, bool *right, struct error *err)
{
    struct yardstick *yardstick = trial->yardstick;
    struct count_run run;
    int result = count_memory(yardstick, &trial->build, family, 0, yardstick->size_count - 1,
                              trial->families[family].costs, &run, err);
    *right = result == 0 && run.failure.verdict == VERDICT_PASSED;
    if (result == 0 && !*right)
        blame_failure(trial, family, run.done, &run.failure);
    if (result == 0 && run.hidden_bytes > 0)
        check_say(
            &trial->checks[CHECK_MEMORY], VERDICT_FLAGGED, &memory_outside_heap,
            "The process grew by %lld bytes more than malloc handed out: a person must "
            "look at it.",
            "El proceso creció %lld bytes más de lo que dio malloc: debe mirarlo una persona.",
            (long long)run.hidden_bytes);
    attempt_release(&run.failure);
    return result;
}

static int count_sizes(struct trial *trial, int family, int first, int last, bool *right,
                       struct error *err)
{
    struct family_result *found = &trial->families[family];
    struct count_run run;
    int result =
        count_work(trial->yardstick, &trial->build, family, first, last,
                   first == 0 ? trial->yardstick->costs[family] : NULL, found->costs, &run, err);
    found->size_count = first + run.done;
    found->hopeless = run.hopeless;
    *right = result == 0 && run.failure.verdict == VERDICT_PASSED;
    if (result == 0 && !*right)
        blame_failure(trial, family, run.done, &run.failure);
    attempt_release(&run.failure);
    return result;
}

/* The reference at the two sizes more, so that every size of a report has its companion. */
static int count_reference(struct yardstick *yardstick, int family, int last, struct error *err)
{
    struct count_run run;
    if (yardstick->costs[family][last].counted)
        return 0;
    int result = count_work(yardstick, &yardstick->reference, family, yardstick->size_count, last,
                            NULL, yardstick->costs[family], &run, err);
    if (result == 0 && run.failure.verdict != VERDICT_PASSED)
        result = error_set(err, "exercise %s: the reference fails at larger sizes: %s",
                           yardstick->exercise->name, run.failure.message.en);
    attempt_release(&run.failure);
    return result;
}

/* ------------------------------------------------------------------ growth */

static int fit(struct trial *trial, int family, enum growth_class allowed, bool last,
               struct error *err)
{
    struct family_result *found = &trial->families[family];
    int64_t counts[SIZES_MAX];
    for (int i = 0; i < found->size_count; i++)
        counts[i] = found->costs[i].counts.instructions;
    found->fitted = true;
    return growth_fit(trial->yardstick->sizes, counts, found->size_count, allowed, last,
                      &found->fit, err);
}

/* "quadratic": a share of the work, behind "is". */
static struct phrase class_adjective(enum growth_class class)
{
    static const struct phrase adjectives[GROWTH_CLASS_COUNT] = {
        {"constant", "constante"}, {"linear", "lineal"},        {"n lg n", "n lg n"},
        {"n^1.5", "n^1.5"},        {"quadratic", "cuadrático"}, {"cubic", "cúbico"}};
    return adjectives[class];
}

/* The work of a family grows faster than is allowed: how much of it, and how. */
static void say_growth(struct trial *trial, int family)
{
    const struct yardstick *yardstick = trial->yardstick;
    const struct family_result *found = &trial->families[family];
    const struct message *elements = &yardstick->exercise->growth_elements;
    struct check_result *check = &trial->checks[CHECK_GROWTH];
    struct phrase adjective = class_adjective(found->fit.class);
    const char *class = growth_class_name(found->fit.class);
    long long size = (long long)yardstick->sizes[found->size_count - 1];
    struct message name;
    message_say(&name, "grows like %s", "crece como %s", class);
    const struct cause cause = {class, message_phrase(&name)};
    if (found->fit.decision == GROWTH_FAIL) {
        check_say(check, VERDICT_GROWS_TOO_FAST, &cause, "%.0f %% of the work is ",
                  "El %.0f %% del trabajo es ", 100 * found->fit.excess);
        message_add_phrase(&check->message, adjective);
    } else {
        check_say(check, VERDICT_GROWS_TOO_FAST, &cause,
                  "The work is far above the reference's and grows like %s",
                  "El trabajo supera con mucho al de la referencia y crece como %s", class);
    }
    message_en(&check->message, " at %lld %s", size, elements->en);
    message_es(&check->message, " con %lld %s", size, elements->es);
    message_add(&check->message, " with the inputs %s; at most %s is allowed.",
                " de las entradas %s; se admite como mucho %s.",
                judge_family_name(yardstick->judge, family), yardstick->exercise->growth_allowed);
}

static int judge_growth(struct trial *trial, int family, bool *right, struct error *err)
{
    const struct exercise *exercise = trial->yardstick->exercise;
    struct family_result *found = &trial->families[family];
    enum growth_class allowed;
    if (growth_class_find(exercise->growth_allowed, &allowed) != 0)
        return error_set(err, "exercise %s: growth: no class \"%s\"", exercise->name,
                         exercise->growth_allowed);
    if (fit(trial, family, allowed, false, err) != 0)
        return -1;
    if (found->fit.decision == GROWTH_UNDECIDED && !found->hopeless) {
        int last = trial->yardstick->size_count + EXTRA_DOUBLINGS - 1;
        if (count_reference(trial->yardstick, family, last, err) != 0 ||
            count_sizes(trial, family, trial->yardstick->size_count, last, right, err) != 0)
            return -1;
        if (!*right)
            return 0;
    }
    if (found->fit.decision == GROWTH_UNDECIDED && fit(trial, family, allowed, true, err) != 0)
        return -1;
    if (found->fit.decision == GROWTH_FAIL || found->hopeless)
        say_growth(trial, family);
    return 0;
}

/* ------------------------------------------------------------------- bands */

static double memory_bytes(const struct cost *cost, int64_t static_bytes)
{
    int64_t bytes = cost->heap_peak_bytes + cost->stack_bytes + static_bytes;
    return (double)(bytes > MEMORY_FLOOR_BYTES ? bytes : MEMORY_FLOOR_BYTES);
}

static void judge_memory(struct trial *trial)
{
    const struct yardstick *yardstick = trial->yardstick;
    struct check_result *check = &trial->checks[CHECK_MEMORY];
    int largest = yardstick->size_count - 1;
    for (int family = 0; family < yardstick->family_count; family++) {
        double ratio =
            memory_bytes(&trial->families[family].costs[largest], trial->build.static_bytes) /
            memory_bytes(&yardstick->costs[family][largest], yardstick->reference.static_bytes);
        if (ratio > trial->memory_ratio) {
            trial->memory_ratio = ratio;
            trial->memory_family = family;
        }
    }
    bool within = trial->memory_ratio <= yardstick->exercise->memory_band;
    check_say(check, within ? VERDICT_PASSED : VERDICT_TOO_MUCH_MEMORY,
              within ? NULL : &memory_band,
              "The peak of memory is %.2f times the reference's (at most %.4g).",
              "El máximo de memoria es %.2f veces el de la referencia (como mucho %.4g).",
              trial->memory_ratio, yardstick->exercise->memory_band);
}

static void find_work_ratios(struct trial *trial, int *family_at_fault)
{
    const struct yardstick *yardstick = trial->yardstick;
    for (int family = 0; family < yardstick->family_count; family++) {
        int largest = trial->families[family].size_count - 1;
        if (largest >= yardstick->size_count)
            largest = yardstick->size_count - 1;
        const struct callgrind_counts *mine = &trial->families[family].costs[largest].counts;
        const struct callgrind_counts *theirs = &yardstick->costs[family][largest].counts;
        double ratio = (double)callgrind_cost(mine) / (double)(callgrind_cost(theirs) + 1);
        if (ratio <= trial->work_ratio)
            continue;
        *family_at_fault = family;
        trial->work_ratio = ratio;
        trial->instruction_ratio = (double)mine->instructions / (double)(theirs->instructions + 1);
        trial->miss_ratio = (double)(mine->l1_misses + mine->ll_misses) /
                            (double)(theirs->l1_misses + theirs->ll_misses + 1);
    }
}

/* Two witnesses: marks for speed are lost only when the counted cost and the paired time agree. */
static int judge_work(struct trial *trial, struct error *err)
{
    const struct exercise *exercise = trial->yardstick->exercise;
    int family = 0;
    bool slower = false;
    find_work_ratios(trial, &family);
    bool above = trial->work_ratio > exercise->work_band;
    if (above && trial_is_slower(trial, family, pace_size_index(trial->yardstick),
                                 exercise->work_band, &slower, err) != 0)
        return -1;
    struct check_result *check = &trial->checks[CHECK_WORK];
    if (!above)
        check_say(check, VERDICT_PASSED, NULL,
                  "The counted cost is %.2f times the reference's (at most %.4g).",
                  "El coste contado es %.2f veces el de la referencia (como mucho %.4g).",
                  trial->work_ratio, exercise->work_band);
    else if (!slower)
        check_say(check, VERDICT_PASSED, NULL,
                  "The counted cost is %.2f times the reference's (at most %.4g), but the time is "
                  "not: that is in your favour.",
                  "El coste contado es %.2f veces el de la referencia (como mucho %.4g), pero el "
                  "tiempo no: la duda te favorece.",
                  trial->work_ratio, exercise->work_band);
    else
        check_say(check, VERDICT_TOO_MUCH_WORK, &work_band,
                  "The counted cost is %.2f times the reference's (at most %.4g), and so is the "
                  "time.",
                  "El coste contado es %.2f veces el de la referencia (como mucho %.4g), y el "
                  "tiempo también.",
                  trial->work_ratio, exercise->work_band);
    return 0;
}

/* ------------------------------------------------------------ counts and time */

/* Counts come from the submission's own process, which can lie to the tool that counts. Time cannot
 * be hidden: an honest program that counts r times the reference's cost takes up to 4.2 r times its
 * time, and a greedy one, which counts little but whose pages the kernel must clear, up to 13.
 * Beyond TIME_FLOOR + TIME_TO_COUNT r a person must look. So a submission that lies within the band
 * can take at most TIME_FLOOR + TIME_TO_COUNT x band times the reference's time; a claim beyond the
 * band loses the mark unless the time is within it. */
static int check_counts(struct trial *trial, struct error *err)
{
    int largest = trial->yardstick->size_count - 1;
    for (int family = 0; family < trial->yardstick->family_count; family++) {
        const struct callgrind_counts *mine = &trial->families[family].costs[largest].counts;
        const struct callgrind_counts *theirs = &trial->yardstick->costs[family][largest].counts;
        double ratio = (double)callgrind_cost(mine) / (double)(callgrind_cost(theirs) + 1);
        double bound = TIME_FLOOR + TIME_TO_COUNT * ratio;
        bool denied;
        struct attempt failure = {0};
        int result = trial_time_denies(trial, family, largest, bound, &denied, &failure, err);
        bool right = failure.verdict == VERDICT_PASSED;
        if (result == 0 && !right)
            blame_failure(trial, family, largest, &failure);
        attempt_release(&failure);
        if (result != 0 || !right)
            return result;
        if (!denied)
            continue;
        for (int i = 0; i < SIZED_CHECKS; i++)
            check_say(
                &trial->checks[sized_checks[i]], VERDICT_FLAGGED, &time_denies_counts,
                "On the inputs %s the counted cost is %.2f times the reference's, but on new "
                "meshes the time is more than %.0f times the reference's, or there is no "
                "answer: a person must look at it.",
                "Con las entradas %s el coste contado es %.2f veces el de la referencia, "
                "pero con mallas nuevas el tiempo es más de %.0f veces el de la referencia, o no "
                "responde: debe mirarlo una persona.",
                judge_family_name(trial->yardstick->judge, family), ratio, bound);
        return 0;
    }
    return 0;
}

/* -------------------------------------------------------------------- step */

static void say_not_measured(struct trial *trial)
{
    for (int i = 0; i < 2; i++)
        check_say(&trial->checks[sized_checks[i]], VERDICT_NOT_MEASURED, &no_valgrind,
                  "Not measured here: %s.", "No se midió aquí: %s.",
                  trial->yardstick->probes.valgrind_reason);
}

int trial_check_growth(struct trial *trial, struct error *err)
{
    const struct yardstick *yardstick = trial->yardstick;
    const struct exercise *exercise = yardstick->exercise;
    bool right = true;
    for (int family = 0; family < yardstick->family_count && right; family++)
        if (measure_memory(trial, family, &right, err) != 0)
            return -1;
    if (!right)
        return 0;
    if (exercise->checked[CHECK_MEMORY] && trial->checks[CHECK_MEMORY].verdict != VERDICT_FLAGGED)
        judge_memory(trial);
    if (!yardstick->probes.valgrind) {
        say_not_measured(trial);
        return 0;
    }
    check_say(&trial->checks[CHECK_GROWTH], VERDICT_PASSED, NULL,
              "The work grows no faster than %s.", "El trabajo no crece más que %s.",
              exercise->growth_allowed);
    for (int family = 0; family < yardstick->family_count && right; family++)
        if (count_sizes(trial, family, 0, yardstick->size_count - 1, &right, err) != 0 ||
            (right && judge_growth(trial, family, &right, err) != 0))
            return -1;
    if (!right || trial->checks[CHECK_GROWTH].verdict != VERDICT_PASSED)
        return 0;
    if (exercise->checked[CHECK_WORK] && judge_work(trial, err) != 0)
        return -1;
    return check_counts(trial, err);
}
