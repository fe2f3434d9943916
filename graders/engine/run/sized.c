/* The checks that rest on sized inputs: growth of the work, amount of work, peak of memory; see
 * sized.h. */
#include "graders/engine/run/sized.h"

#include "graders/engine/run/cases.h"
#include "graders/engine/run/pace.h"
#include "reference/base/plural.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct cause memory_outside_heap = {
    "memory-outside-heap", {"memory outside malloc", "memoria fuera de malloc"}};
static const struct cause memory_band = {
    "memory-band", {"memory above the band", "memoria por encima del margen"}};
static const struct cause work_band = {"work-band",
                                       {"work above the band", "trabajo por encima del margen"}};
static const struct cause access_band = {"access-band",
                                         {"too many accesses", "demasiados accesos"}};
static const struct cause time_denies_counts = {
    "time-denies-counts", {"time contradicts the counts", "el tiempo contradice las cuentas"}};
static const struct cause no_valgrind = {"no-valgrind", {"no valgrind", "sin valgrind"}};

enum {
    MEMORY_FLOOR_BYTES = 4096, /* so that a reference that allocates nothing can be divided by */
    TIME_FLOOR = 30,           /* see check_counts */
    TIME_TO_COUNT = 5          /* see check_counts */
};

/* What is judged of each part, at the sizes of its families. */
static const enum check_kind growth_checks[] = {CHECK_GROWTH, CHECK_QUERY_GROWTH};
static const enum check_kind work_checks[] = {CHECK_WORK, CHECK_QUERY_WORK};
static const enum check_kind memory_checks[] = {CHECK_MEMORY, CHECK_QUERY_MEMORY};

static const enum check_kind sized_checks[] = {
    CHECK_GROWTH,   CHECK_QUERY_GROWTH, CHECK_WORK,         CHECK_QUERY_WORK,
    CHECK_ACCESSES, CHECK_MEMORY,       CHECK_QUERY_MEMORY,
};
enum {
    SIZED_CHECKS = sizeof sized_checks / sizeof sized_checks[0],
    COUNTED_CHECKS = SIZED_CHECKS - PART_COUNT /* all but memory rest on callgrind */
};

static enum exercise_part part_of(const struct trial *trial, int family)
{
    return trial->yardstick->inputs.judge->families[family].is_query ? PART_QUERY : PART_BUILD;
}

/* --------------------------------------------------------------- measuring */

/* A call on a sized input went wrong: no check that rests on it can pass. It is a failure of its
 * own only when every case was right and the sanitizers found nothing; otherwise these tell the
 * mistake, and better. */
static void blame_failure(struct trial *trial, int family, int size_index,
                          const struct attempt *failure)
{
    const struct yardstick *yardstick = trial->yardstick;
    enum verdict found = trial->checks[CHECK_UNDEFINED_BEHAVIOUR].verdict;
    bool is_told = cases_any_failed(trial) ||
                   (found == VERDICT_UNDEFINED_BEHAVIOUR && failure->verdict != VERDICT_FLAGGED);
    enum verdict verdict = is_told ? VERDICT_NOT_REACHED : failure->verdict;
    const struct cause cause = attempt_cause(failure);
    for (int i = 0; i < SIZED_CHECKS; i++) {
        struct check_result *check = &trial->checks[sized_checks[i]];
        check_say(check, verdict, &cause, "With the input %s of size about %lld: ",
                  "Con la entrada %s de tamaño %lld, más o menos: ",
                  judge_family_name(yardstick->inputs.judge, family),
                  (long long)yardstick->inputs.told_sizes[size_index]);
        message_add_phrase(&check->message, message_phrase(&failure->message));
    }
}

/* A leak that only shows with larger inputs than those of the cases. */
static void blame_leak(struct trial *trial, int family, const struct count_run *run)
{
    const struct inputs *inputs = &trial->yardstick->inputs;
    struct check_result *check = &trial->checks[CHECK_LEAK];
    if (check->verdict == VERDICT_PASSED)
        check_say(check, VERDICT_LEAK, &check_leaked_blocks,
                  "With the input %s of size about %lld your function leaves %lld byte%s in %lld "
                  "block%s that nobody can free any more.",
                  "Con la entrada %s de tamaño %lld, más o menos, tu función deja %lld byte%s en "
                  "%lld bloque%s que ya nadie puede liberar.",
                  judge_family_name(inputs->judge, family),
                  (long long)inputs->told_sizes[run->leaking_size], (long long)run->leaked_bytes,
                  plural_ending(run->leaked_bytes), (long long)run->leaked_blocks,
                  plural_ending(run->leaked_blocks));
}

static int measure_memory(struct trial *trial, int family, bool *right, struct error *err)
{
    struct yardstick *yardstick = trial->yardstick;
    struct cost *costs[FAMILIES_MAX] = {[0] = NULL};
    struct count_plan plan = {
        .first_family = family, .last_family = family, .last = inputs_beyond(&yardstick->inputs)};
    struct count_run run;
    costs[family] = trial->families[family].costs;
    int result = count_memory(&yardstick->inputs, &trial->build, &plan, costs, &run, err);
    *right = result == 0 && run.failure.verdict == VERDICT_PASSED;
    if (result == 0 && !*right)
        blame_failure(trial, run.family, run.size_index, &run.failure);
    if (result == 0 && run.hidden_bytes > 0)
        check_say(
            &trial->checks[memory_checks[part_of(trial, family)]], VERDICT_FLAGGED,
            &memory_outside_heap,
            "The process grew by %lld bytes more than malloc handed out: a person must "
            "look at it.",
            "El proceso creció %lld bytes más de lo que dio malloc: debe mirarlo una persona.",
            (long long)run.hidden_bytes);
    if (result == 0 && run.leaked_blocks > 0)
        blame_leak(trial, family, &run);
    attempt_release(&run.failure);
    return result;
}

static int count_sizes(struct trial *trial, const struct count_plan *plan, bool *right,
                       struct error *err)
{
    struct cost *costs[FAMILIES_MAX] = {[0] = NULL};
    struct count_plan beside = *plan;
    struct count_run run;
    for (int family = 0; family < trial->yardstick->inputs.family_count; family++) {
        costs[family] = trial->families[family].costs;
        beside.reference[family] = trial->yardstick->costs[family];
    }
    int result = count_work(&trial->yardstick->inputs, &trial->build, &beside, costs, &run, err);
    for (int family = plan->first_family; family <= plan->last_family; family++) {
        if (trial->families[family].size_count < run.end[family])
            trial->families[family].size_count = run.end[family];
        trial->families[family].hopeless = run.hopeless[family];
    }
    *right = result == 0 && run.failure.verdict == VERDICT_PASSED;
    if (result == 0 && !*right)
        blame_failure(trial, run.family, run.size_index, &run.failure);
    attempt_release(&run.failure);
    return result;
}

/* The reference at larger sizes, so that every size of a report has its companion. */
static int count_reference(struct yardstick *yardstick, const struct count_plan *plan,
                           struct error *err)
{
    int family = plan->first_family;
    struct cost *costs[FAMILIES_MAX] = {[0] = NULL};
    struct count_run run;
    if (yardstick->costs[family][plan->last].counted)
        return 0;
    costs[family] = yardstick->costs[family];
    int result = count_work(&yardstick->inputs, &yardstick->reference, plan, costs, &run, err);
    if (result == 0 && run.failure.verdict != VERDICT_PASSED)
        result = error_set(err, "exercise %s: the reference fails at larger sizes: %s",
                           yardstick->inputs.exercise->name, run.failure.message.en);
    attempt_release(&run.failure);
    return result;
}

/* ------------------------------------------------------------------ growth */

static int fit(struct trial *trial, int family, enum growth_look look, struct error *err)
{
    const struct exercise *exercise = trial->yardstick->inputs.exercise;
    struct family_result *found = &trial->families[family];
    const char *allowed_name = exercise->growth_allowed[part_of(trial, family)];
    enum growth_class allowed;
    int64_t sizes[SIZES_MAX], counts[SIZES_MAX];
    int count = 0;
    if (growth_class_find(allowed_name, &allowed) != 0)
        return error_set(err, "exercise %s: growth: no class \"%s\"", exercise->name, allowed_name);
    for (int i = 0; i < found->size_count; i++) {
        if (!found->costs[i].counted)
            continue;
        sizes[count] = trial->yardstick->inputs.sizes[family][i];
        counts[count++] = found->costs[i].counts.instructions;
    }
    found->fitted = true;
    return growth_fit(sizes, counts, count, allowed, look, &found->fit, err);
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
    const struct message *elements = &yardstick->inputs.exercise->growth_elements;
    enum exercise_part part = part_of(trial, family);
    struct check_result *check = &trial->checks[growth_checks[part]];
    struct phrase adjective = class_adjective(found->fit.class);
    const char *class = growth_class_name(found->fit.class);
    long long size = (long long)yardstick->inputs.told_sizes[found->size_count - 1];
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
    message_en(&check->message, " at some %lld %s", size, elements->en);
    message_es(&check->message, " con unos %lld %s", size, elements->es);
    message_add(&check->message, " with the inputs %s; at most %s is allowed.",
                " de las entradas %s; se admite como mucho %s.",
                judge_family_name(yardstick->inputs.judge, family),
                yardstick->inputs.exercise->growth_allowed[part]);
}

/* The first size below `count` at which a family is not counted; `count` when there is none. */
static int first_gap(const struct family_result *found, int count)
{
    int at = 0;
    while (at < count && found->costs[at].counted)
        at++;
    return at;
}

/* Counts one family at the sizes first ... last as well, unless its growth is decided. */
static int look_closer(struct trial *trial, int family, int first, int last, bool *right,
                       struct error *err)
{
    const struct family_result *found = &trial->families[family];
    struct count_plan plan = {.first_family = family,
                              .last_family = family,
                              .first = first,
                              .last = last,
                              .stops_early = true,
                              .without_misses = true};
    if (!*right || found->fit.decision != GROWTH_UNDECIDED || found->hopeless || first > last)
        return 0;
    if (count_reference(trial->yardstick, &plan, err) != 0 ||
        count_sizes(trial, &plan, right, err) != 0)
        return -1;
    return *right ? fit(trial, family, GROWTH_FULL_LOOK, err) : 0;
}

static int judge_growth(struct trial *trial, int family, bool *right, struct error *err)
{
    const struct yardstick *yardstick = trial->yardstick;
    struct family_result *found = &trial->families[family];
    int count = yardstick->inputs.size_count, gap = first_gap(found, count);
    bool has_all = found->hopeless || gap == count;
    if (fit(trial, family, has_all ? GROWTH_FULL_LOOK : GROWTH_FIRST_LOOK, err) != 0 ||
        look_closer(trial, family, gap, count - 2, right, err) != 0 ||
        look_closer(trial, family, count, count + EXTRA_DOUBLINGS - 1, right, err) != 0)
        return -1;
    if (!*right)
        return 0;
    if (found->fit.decision == GROWTH_UNDECIDED && !found->hopeless &&
        fit(trial, family, GROWTH_LAST_LOOK, err) != 0)
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

/* What a submission takes at a size, as a multiple of the reference. Below the largest size, what
 * it takes at the smallest is left out on both sides: a table of fixed size, or the first block of a
 * growing one, weighs most where the input is small. */
static double memory_ratio_at(const struct trial *trial, int family, int size_index)
{
    const struct yardstick *yardstick = trial->yardstick;
    const struct cost *mine = trial->families[family].costs, *theirs = yardstick->costs[family];
    double my_bytes = memory_bytes(&mine[size_index], trial->build.static_bytes);
    double their_bytes = memory_bytes(&theirs[size_index], yardstick->reference.static_bytes);
    if (size_index < inputs_beyond(&yardstick->inputs)) {
        my_bytes -= memory_bytes(&mine[0], trial->build.static_bytes);
        their_bytes -= memory_bytes(&theirs[0], yardstick->reference.static_bytes);
        their_bytes = fmax(their_bytes, MEMORY_FLOOR_BYTES);
    }
    return my_bytes / their_bytes;
}

/* The largest size speaks, and every other where more is taken than the band allows. */
static void find_memory_ratio(struct trial *trial, enum exercise_part part)
{
    struct part_result *found = &trial->parts[part];
    double band = trial->yardstick->inputs.exercise->memory_band[part];
    const struct inputs *inputs = &trial->yardstick->inputs;
    found->memory_size = inputs_beyond(inputs);
    for (int i = found->memory_size; i > 0; i--)
        for (int family = 0; family < inputs->family_count; family++) {
            double ratio = memory_ratio_at(trial, family, i);
            bool speaks = i == inputs_beyond(inputs) || ratio > band;
            if (part_of(trial, family) == part && speaks && ratio > found->memory_ratio) {
                found->memory_ratio = ratio;
                found->memory_family = family;
                found->memory_size = i;
            }
        }
}

static void judge_memory(struct trial *trial, enum exercise_part part)
{
    const struct exercise *exercise = trial->yardstick->inputs.exercise;
    struct check_result *check = &trial->checks[memory_checks[part]];
    const struct part_result *found = &trial->parts[part];
    double band = exercise->memory_band[part];
    if (!exercise->checked[memory_checks[part]] || check->verdict == VERDICT_FLAGGED)
        return;
    find_memory_ratio(trial, part);
    bool within = found->memory_ratio <= band;
    check_say(check, within ? VERDICT_PASSED : VERDICT_TOO_MUCH_MEMORY,
              within ? NULL : &memory_band,
              "The peak of memory is %.2f times the reference's (at most %.4g).",
              "El máximo de memoria es %.2f veces el de la referencia (como mucho %.4g).",
              found->memory_ratio, band);
}

/* The largest size at which both were counted with everything. */
static int largest_counted(const struct trial *trial, int family)
{
    int mine = trial->families[family].size_count, all = trial->yardstick->inputs.size_count;
    return (mine < all ? mine : all) - 1;
}

/* callgrind saw each access: the count needs no second witness. */
static void judge_accesses(struct trial *trial)
{
    const struct yardstick *yardstick = trial->yardstick;
    struct check_result *check = &trial->checks[CHECK_ACCESSES];
    for (int family = 0; family < yardstick->inputs.family_count; family++) {
        int largest = largest_counted(trial, family);
        double ratio = (double)trial->families[family].costs[largest].access_count /
                       (double)(yardstick->costs[family][largest].access_count + 1);
        if (ratio > trial->access_ratio) {
            trial->access_ratio = ratio;
            trial->access_family = family;
        }
    }
    bool within = trial->access_ratio <= yardstick->inputs.exercise->access_band;
    check_say(check, within ? VERDICT_PASSED : VERDICT_TOO_MUCH_WORK, within ? NULL : &access_band,
              "The structure was accessed %.2f times as often as by the reference (at most %.4g).",
              "Se accedió a la estructura %.2f veces lo que la referencia (como mucho %.4g).",
              trial->access_ratio, yardstick->inputs.exercise->access_band);
}

static void find_work_ratios(struct trial *trial, enum exercise_part part, int *family_at_fault)
{
    struct part_result *found = &trial->parts[part];
    const struct yardstick *yardstick = trial->yardstick;
    for (int family = 0; family < yardstick->inputs.family_count; family++) {
        int largest = largest_counted(trial, family);
        const struct callgrind_counts *mine = &trial->families[family].costs[largest].counts;
        const struct callgrind_counts *theirs = &yardstick->costs[family][largest].counts;
        double ratio = (double)callgrind_cost(mine) / (double)(callgrind_cost(theirs) + 1);
        if (part_of(trial, family) != part || ratio <= found->work_ratio)
            continue;
        *family_at_fault = family;
        found->work_ratio = ratio;
        found->instruction_ratio = (double)mine->instructions / (double)(theirs->instructions + 1);
        found->miss_ratio = (double)(mine->l1_misses + mine->ll_misses) /
                            (double)(theirs->l1_misses + theirs->ll_misses + 1);
    }
}

/* Two witnesses: marks for speed are lost only when the counted cost and the paired time agree. */
static int judge_work(struct trial *trial, enum exercise_part part, struct error *err)
{
    const struct exercise *exercise = trial->yardstick->inputs.exercise;
    const double band = exercise->work_band[part];
    int family = 0;
    bool slower = false;
    if (!exercise->checked[work_checks[part]])
        return 0;
    find_work_ratios(trial, part, &family);
    const double ratio = trial->parts[part].work_ratio;
    bool above = ratio > band;
    if (above &&
        pace_is_slower(trial, family, pace_size_index(trial->yardstick), band, &slower, err) != 0)
        return -1;
    struct check_result *check = &trial->checks[work_checks[part]];
    if (!above)
        check_say(check, VERDICT_PASSED, NULL,
                  "The counted cost is %.2f times the reference's (at most %.4g).",
                  "El coste contado es %.2f veces el de la referencia (como mucho %.4g).", ratio,
                  band);
    else if (!slower)
        check_say(check, VERDICT_PASSED, NULL,
                  "The counted cost is %.2f times the reference's (at most %.4g), but the time is "
                  "not: that is in your favour.",
                  "El coste contado es %.2f veces el de la referencia (como mucho %.4g), pero el "
                  "tiempo no: la duda te favorece.",
                  ratio, band);
    else
        check_say(check, VERDICT_TOO_MUCH_WORK, &work_band,
                  "The counted cost is %.2f times the reference's (at most %.4g), and so is the "
                  "time.",
                  "El coste contado es %.2f veces el de la referencia (como mucho %.4g), y el "
                  "tiempo también.",
                  ratio, band);
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
    int largest = trial->yardstick->inputs.size_count - 1;
    int beyond = inputs_beyond(&trial->yardstick->inputs); /* nothing was counted there */
    for (int family = 0; family < trial->yardstick->inputs.family_count; family++) {
        const struct callgrind_counts *mine = &trial->families[family].costs[largest].counts;
        const struct callgrind_counts *theirs = &trial->yardstick->costs[family][largest].counts;
        double ratio = (double)callgrind_cost(mine) / (double)(callgrind_cost(theirs) + 1);
        double bound = TIME_FLOOR + TIME_TO_COUNT * ratio;
        bool denied;
        struct attempt failure = {0};
        int result = pace_time_denies(trial, family, beyond, bound, &denied, &failure, err);
        bool right = failure.verdict == VERDICT_PASSED;
        if (result == 0 && !right)
            blame_failure(trial, family, beyond, &failure);
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
                judge_family_name(trial->yardstick->inputs.judge, family), ratio, bound);
        return 0;
    }
    return 0;
}

/* -------------------------------------------------------------------- step */

static void say_not_measured(struct trial *trial)
{
    struct phrase why = trial->yardstick->probes.no_valgrind;
    for (int i = 0; i < COUNTED_CHECKS; i++) {
        struct check_result *check = &trial->checks[sized_checks[i]];
        check_say(check, VERDICT_NOT_MEASURED, &no_valgrind,
                  "Not measured here: ", "No se midió aquí: ");
        message_add_phrase(&check->message, why);
        message_add(&check->message, ".", ".");
    }
}

int sized_check_memory(struct trial *trial, bool *right, struct error *err)
{
    *right = true;
    for (int family = 0; family < trial->yardstick->inputs.family_count && *right; family++)
        if (measure_memory(trial, family, right, err) != 0)
            return -1;
    for (int part = 0; part < PART_COUNT && *right; part++)
        judge_memory(trial, part);
    return 0;
}

int sized_check_growth(struct trial *trial, struct error *err)
{
    const struct yardstick *yardstick = trial->yardstick;
    const struct exercise *exercise = yardstick->inputs.exercise;
    bool right = true;
    if (!yardstick->probes.valgrind) {
        say_not_measured(trial);
        return 0;
    }
    for (int part = 0; part < PART_COUNT; part++)
        check_say(&trial->checks[growth_checks[part]], VERDICT_PASSED, NULL,
                  "The work grows no faster than %s.", "El trabajo no crece más que %s.",
                  exercise->growth_allowed[part]);
    struct count_plan plan = {.last_family = yardstick->inputs.family_count - 1,
                              .last = yardstick->inputs.size_count - 1,
                              .leaps = true,
                              .stops_early = true};
    if (yardstick->inputs.family_count > 0 && count_sizes(trial, &plan, &right, err) != 0)
        return -1;
    for (int family = 0; family < yardstick->inputs.family_count && right; family++)
        if (judge_growth(trial, family, &right, err) != 0)
            return -1;
    for (int part = 0; part < PART_COUNT; part++)
        right = right && trial->checks[growth_checks[part]].verdict == VERDICT_PASSED;
    if (!right)
        return 0;
    if (exercise->checked[CHECK_ACCESSES])
        judge_accesses(trial);
    for (int part = 0; part < PART_COUNT; part++)
        if (judge_work(trial, part, err) != 0)
            return -1;
    return check_counts(trial, err);
}

int sized_check(struct trial *trial, struct error *err)
{
    bool right;
    if (sized_check_memory(trial, &right, err) != 0)
        return -1;
    return right ? sized_check_growth(trial, err) : 0;
}
