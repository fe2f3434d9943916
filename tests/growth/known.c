/* The growth decision on real solutions whose growth is known.
 *
 * The solutions are the texts beside this file, each with a base algorithm and some extra work.
 * A step, as a further pass of a radix sort or a table that outgrows a cache makes it, is no growth.
 * They are built and counted as submissions are; the engine's own check decides. Prints a table in
 * Markdown; exits 1 when a decision is wrong that must be right: everything but hidden quadratic
 * terms below 1/64.
 *
 * Then the counts of every right solution are varied by 0.3 % at random, 1000 times: how often
 * would the variation fail it?
 *
 *   known [EXERCISE [BASE]]     run from anywhere below the project */
#include "graders/engine/base/files.h"
#include "graders/engine/run/sized.h"
#include "graders/engine/run/trial.h"
#include "reference/base/random.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EXTRA_NONE, EXTRA_PAIRS, EXTRA_SQRT, EXTRA_BACKWARD, EXTRA_STEP };
enum { TRIALS = 1000, WEAKEST_REQUIRED_SHARE = 64 };
static const double VARIATION = 0.003;

struct base {
    const char *name;
    const char *class;
};

static const struct base edge_bases[] = {
    {"hash, fixed capacity", "n"},
    {"hash, x2 at 1/2", "n"},
    {"hash, x4 at 3/4", "n"},
    {"hash, x1.5 at 3/5", "n"},
    {"hash, x2 from 100 at 85 %", "n"},
    {"hash, chains of nodes", "n"},
    {"qsort", "n lg n"},
    {"heap sort", "n lg n"},
    {"merge sort", "n lg n"},
    {"radix sort", "n"},
    {"search tree (treap)", "n lg n"},
};
static const struct base area_bases[] = {
    {"cross products", "n"}, {"base times height", "n"}, {"compensated sum", "n"}};

static const struct subject {
    const char *exercise;
    const struct base *bases;
    int base_count;
} subjects[] = {
    {"edge-table-any", edge_bases, sizeof edge_bases / sizeof *edge_bases},
    {"mesh-area", area_bases, sizeof area_bases / sizeof *area_bases},
};
enum { SUBJECT_COUNT = sizeof subjects / sizeof *subjects };

static const struct extra {
    const char *name;
    int kind, share;
    const char *class; /* NULL: that of the base, which must pass */
} extras[] = {
    {"nothing", EXTRA_NONE, 1, NULL},
    {"1/16 of all pairs", EXTRA_PAIRS, 16, "n^2"},
    {"1/32 of all pairs", EXTRA_PAIRS, 32, "n^2"},
    {"1/64 of all pairs", EXTRA_PAIRS, 64, "n^2"},
    {"1/128 of all pairs", EXTRA_PAIRS, 128, "n^2"},
    {"1/256 of all pairs", EXTRA_PAIRS, 256, "n^2"},
    {"sqrt(n) others of each", EXTRA_SQRT, 1, "n^1.5"},
    {"all before each", EXTRA_BACKWARD, 1, "n^2"},
    {"one pass more from 400 on", EXTRA_STEP, 400, NULL},
    {"one pass more from 1500 on", EXTRA_STEP, 1500, NULL},
    {"one pass more from 5000 on", EXTRA_STEP, 5000, NULL},
    {"one pass more from 7000 on", EXTRA_STEP, 7000, NULL},
    {"one pass more from 12000 on", EXTRA_STEP, 12000, NULL},
};
enum { EXTRA_COUNT = sizeof extras / sizeof *extras };

struct totals {
    int right, wrong, beyond; /* beyond: hidden terms below 1/64, whatever was decided */
    long trials, false_fails;
};

/* --------------------------------------------------------------------- one solution */

static char *solution_text(const char *exercise, int base, const struct extra *extra,
                           struct error *err)
{
    char path[PATH_MAX], *text, *whole = NULL;
    size_t count;
    const char *root = project_root(err);
    if (!root)
        return NULL;
    snprintf(path, sizeof path, "%s/tests/growth/%s.c", root, exercise);
    if (file_read(path, 1 << 20, &text, &count, err) != 0)
        return NULL;
    if (asprintf(&whole, "#define BASE %d\n#define EXTRA %d\n#define SHARE %d\n#line 1\n%.*s", base,
                 extra->kind, extra->share, (int)count, text) < 0)
        whole = NULL;
    free(text);
    return whole;
}

/* Builds and counts. The caller releases the trial. */
static int measure(struct yardstick *yardstick, const char *text, struct trial *trial,
                   struct error *err)
{
    struct source source = {"answer.c", text, strlen(text)};
    memset(trial, 0, sizeof *trial);
    trial->yardstick = yardstick;
    trial->cases = calloc(yardstick->inputs.judge->case_count, sizeof *trial->cases);
    if (!trial->cases)
        return error_set(err, "out of memory");
    if (build_submission(yardstick->inputs.exercise, &source, 1, BUILD_PLAIN, &trial->build, err) !=
        0)
        return -1;
    if (trial->build.refusal.refused)
        return error_set(err, "does not build: %s %.300s", trial->build.refusal.message.en,
                         trial->build.diagnostics);
    return sized_check(trial, err);
}

/* How many of TRIALS variations of the counts would fail the growth. Where the first sizes leave it
 * undecided, the stricter bound of the last round decides on them. */
static int false_fails(const struct trial *trial, enum growth_class allowed, struct random *random)
{
    const struct yardstick *yardstick = trial->yardstick;
    int fails = 0;
    for (int i = 0; i < TRIALS; i++) {
        bool failed = false;
        for (int family = 0; family < yardstick->inputs.family_count; family++) {
            int64_t counts[SIZES_MAX];
            struct growth_fit fit;
            struct error ignored;
            const struct cost *costs = trial->families[family].costs;
            int64_t sizes[SIZES_MAX];
            int counted = 0;
            for (int s = 0; s < yardstick->inputs.size_count; s++) {
                double normal = sqrt(-2 * log(1 - random_real(random))) *
                                cos(2 * 3.14159265358979323846 * random_real(random));
                if (!costs[s].counted)
                    continue;
                sizes[counted] = yardstick->inputs.sizes[family][s];
                counts[counted++] =
                    (int64_t)((double)costs[s].counts.instructions * (1 + VARIATION * normal));
            }
            bool all = counted == yardstick->inputs.size_count;
            if (growth_fit(sizes, counts, counted, allowed,
                           all ? GROWTH_FULL_LOOK : GROWTH_FIRST_LOOK, &fit, &ignored) == 0 &&
                fit.decision == GROWTH_UNDECIDED)
                (void)!growth_fit(sizes, counts, counted, allowed, GROWTH_LAST_LOOK, &fit,
                                  &ignored);
            failed = failed || fit.decision == GROWTH_FAIL;
        }
        fails += failed;
    }
    return fails;
}

/* ------------------------------------------------------------------------- the table */

static void print_row(const struct trial *trial, const struct base *base, const struct extra *extra,
                      const char *decided, const char *remark)
{
    const struct family_result *worst = &trial->families[0];
    for (int family = 1; family < trial->yardstick->inputs.family_count; family++)
        if (trial->families[family].fit.excess > worst->fit.excess)
            worst = &trial->families[family];
    int counted = 0;
    for (int i = 0; i < worst->size_count; i++)
        counted += worst->costs[i].counted;
    printf("| %s | %s | %s | %s | %s | %.2f | %.2f | %d | %s |\n",
           trial->yardstick->inputs.exercise->name, base->name, extra->name,
           extra->class ? extra->class : base->class, decided, worst->fit.excess,
           worst->fit.exponent, counted, remark);
    fflush(stdout);
}

static int try_solution(struct yardstick *yardstick, const struct base *base, int base_number,
                        const struct extra *extra, struct random *random, struct totals *totals,
                        struct error *err)
{
    struct trial trial;
    enum growth_class allowed;
    char *text = solution_text(yardstick->inputs.exercise->name, base_number, extra, err);
    if (!text)
        return -1;
    int result = measure(yardstick, text, &trial, err);
    if (result == 0)
        result =
            growth_class_find(yardstick->inputs.exercise->growth_allowed[PART_BUILD], &allowed);
    if (result == 0) {
        enum verdict verdict = trial.checks[CHECK_GROWTH].verdict;
        bool fails = verdict == VERDICT_GROWS_TOO_FAST, must_fail = extra->class != NULL;
        bool required = extra->kind != EXTRA_PAIRS || extra->share <= WEAKEST_REQUIRED_SHARE;
        bool right = fails == must_fail && (fails || verdict == VERDICT_PASSED);
        *(required ? right ? &totals->right : &totals->wrong : &totals->beyond) += 1;
        print_row(&trial, base, extra, fails ? "fails" : "passes",
                  right      ? ""
                  : required ? "**wrong**"
                             : "not seen");
        if (!must_fail) {
            totals->trials += TRIALS;
            totals->false_fails += false_fails(&trial, allowed, random);
        }
    }
    trial_release(&trial);
    free(text);
    return result;
}

static int try_subject(const struct subject *subject, const struct exercise *exercise, int only,
                       struct random *random, struct totals *totals, struct error *err)
{
    struct yardstick yardstick;
    int result = yardstick_make(&yardstick, exercise, seeds_of_class(SEED_PUBLISHED), false, err);
    if (result == 0 && !yardstick.probes.valgrind)
        result = error_set(err, "nothing can be counted here: %s",
                           phrase_text(yardstick.probes.no_valgrind, LANGUAGE_EN));
    for (int base = 0; result == 0 && base < subject->base_count; base++)
        for (int e = 0; result == 0 && e < EXTRA_COUNT && (only < 0 || base == only); e++)
            result = try_solution(&yardstick, &subject->bases[base], base, &extras[e], random,
                                  totals, err);
    yardstick_release(&yardstick);
    return result;
}

int main(int argc, char **argv)
{
    struct exercise *exercises = NULL;
    struct error err = {0};
    struct totals totals = {0};
    struct random random;
    int count = 0, result = 0;
    const char *root = project_root(&err);
    random_init(&random, 20261122);
    if (!root || exercises_read(root, &exercises, &count, &err) != 0)
        result = -1;
    else
        printf("| exercise | base | extra work | true class | decision | excess | exponent | sizes "
               "| |\n"
               "|---|---|---|---|---|---|---|---|---|\n");
    for (int i = 0; result == 0 && i < SUBJECT_COUNT; i++)
        if (argc < 2 || strcmp(argv[1], subjects[i].exercise) == 0)
            result =
                try_subject(&subjects[i], exercise_find(exercises, count, subjects[i].exercise),
                            argc > 2 ? atoi(argv[2]) : -1, &random, &totals, &err);
    free(exercises);
    if (result != 0) {
        fprintf(stderr, "growth: %s\n", err.text);
        return 2;
    }
    printf("\n%d solutions: %d of %d decided right; %d with a hidden term below 1/%d beside.\n"
           "Counts varied by %.1f %%: %ld of %ld variations fail a right solution.\n",
           totals.right + totals.wrong + totals.beyond, totals.right, totals.right + totals.wrong,
           totals.beyond, WEAKEST_REQUIRED_SHARE, 100 * VARIATION, totals.false_fails,
           totals.trials);
    return totals.wrong > 0 || totals.false_fails * 1000 > totals.trials;
}
