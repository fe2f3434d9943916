/* The second witness of speed on this machine, under load: how often is it wrong?
 *
 * Submissions are timed against the reference in pairs, as grading does. The median of many pairs
 * is a submission's true ratio; the bound is then set so that the true ratio is 0.7 and 1.5 times
 * the bound, and the decision is taken again and again, each time in fresh processes. Beside it run
 * busy processes. The first witness, the counted cost, repeats bit for bit and cannot err.
 *
 * Decisions are held against the truth only where there is one: submissions that do the reference's
 * own work two and three times over, so that load slows both alike. Of the others, which use the
 * caches in ways of their own, load moves the ratio itself; they are shown beside, for information.
 *
 *   two_witness [DECISIONS [BUSY]]     defaults 1000 and twice the number of cores
 *
 * Prints a table in Markdown; exits 1 when a decision at 0.7 or 1.5 was wrong. */
#include "graders/engine/base/files.h"
#include "graders/engine/run/pace.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

enum { BUSY_MAX = 64, MEDIAN_PAIRS = 151 };

static const struct subject {
    const char *exercise, *path; /* below tests */
    int repeats;                 /* of the reference's work; 0: a submission by itself */
} subjects[] = {
    {"mesh-area", "pace/repeated/mesh-area.c", 2},
    {"edge-table-any", "pace/repeated/edge-table-any.c", 2},
    {"edge-table-any", "pace/repeated/edge-table-any.c", 3},
    {"edge-table-closed", "pace/repeated/edge-table-closed.c", 2},
    {"mesh-area", "submissions/processing/mesh-area/slow/slices.c", 0},
    {"edge-table-any", "submissions/edges/edge-table-any/right/sort.c", 0},
    {"edge-table-any", "submissions/edges/edge-table-any/right/hash-table.c", 0},
    {"edge-table-closed", "submissions/edges/edge-table-closed/slow/sort.c", 0},
};
enum { SUBJECT_COUNT = sizeof subjects / sizeof *subjects, REPEATED_COUNT = 4 };

/* True ratios in bounds. The middle ones are for information: near 1 any rule tosses a coin. */
static const struct distance {
    double factor;
    bool required;
} distances[] = {{0.7, true}, {0.9, false}, {1.1, false}, {1.5, true}};
enum { DISTANCE_COUNT = sizeof distances / sizeof *distances };

/* ----------------------------------------------------------------------- load */

static pid_t busy[BUSY_MAX];
static int busy_count;

static void start_busy(int count)
{
    for (busy_count = 0; busy_count < count && busy_count < BUSY_MAX; busy_count++) {
        busy[busy_count] = fork();
        if (busy[busy_count] == 0) {
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            for (volatile unsigned spin = 0;; spin++) {
            }
        }
    }
}

static void stop_busy(void)
{
    for (int i = 0; i < busy_count; i++)
        if (busy[i] > 0) {
            kill(busy[i], SIGKILL);
            waitpid(busy[i], NULL, 0);
        }
}

/* -------------------------------------------------------------------- decisions */

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int find_true_ratio(struct trial *trial, int size_index, double *median, struct error *err)
{
    double ratios[MEDIAN_PAIRS];
    struct pace pace;
    int result = pace_start(&pace, trial, 0, size_index, err);
    for (int i = 0; result == 0 && i < MEDIAN_PAIRS; i++)
        if (pace_pair(&pace, &ratios[i], err) != 0 || pace.gone || !pace.right)
            result = error_set(err, "a pair failed while the true ratio was measured");
    if (pace_end(&pace, err) != 0 || result != 0)
        return -1;
    qsort(ratios, MEDIAN_PAIRS, sizeof *ratios, by_size);
    *median = ratios[MEDIAN_PAIRS / 2];
    return 0;
}

static int decide(struct trial *trial, const struct subject *subject, int decisions,
                  int *wrong_required, struct error *err)
{
    double true_ratio;
    const char *name = strrchr(subject->path, '/') + 1;
    int size_index = pace_size_index(trial->yardstick);
    if (find_true_ratio(trial, size_index, &true_ratio, err) != 0)
        return -1;
    if (subject->repeats > 0)
        printf("| %s, the reference %d times | %.2f |", subject->exercise, subject->repeats,
               true_ratio);
    else
        printf("| %s, %s | %.2f |", subject->exercise, name, true_ratio);
    for (int d = 0; d < DISTANCE_COUNT; d++) {
        int wrong = 0, count = distances[d].required ? decisions : decisions / 5 + 1;
        for (int i = 0; i < count; i++) {
            bool slower;
            if (pace_is_slower(trial, 0, size_index, true_ratio / distances[d].factor, &slower,
                               err) != 0)
                return -1;
            wrong += slower != (distances[d].factor > 1);
        }
        *wrong_required += subject->repeats > 0 && distances[d].required ? wrong : 0;
        printf(" %d of %d |", wrong, count);
        fflush(stdout);
    }
    puts("");
    return 0;
}

/* The reference under another name, and the file that calls it again and again. */
static int build_repeated(const struct subject *subject, const struct exercise *exercise,
                          const char *root, const char *text, struct build *build,
                          struct error *err)
{
    char path[PATH_MAX], function[EXERCISE_NAME], *reference = NULL, *once = NULL, *calls = NULL;
    size_t bytes;
    snprintf(function, sizeof function, "%s", exercise->name);
    for (char *c = function; *c; c++)
        *c = *c == '-' ? '_' : *c;
    snprintf(path, sizeof path, "%s/reference/answers/%s/%s.c", root, exercise->group,
             exercise->name);
    if (file_read(path, 1 << 20, &reference, &bytes, err) != 0)
        return -1;
    int result = -1;
    if (asprintf(&once, "#define %s reference_once\n%s", function, reference) < 0 ||
        asprintf(&calls, "#define REPEATS %d\n%s", subject->repeats, text) < 0) {
        error_set(err, "out of memory");
    } else {
        struct source sources[] = {{"once.c", once, strlen(once)},
                                   {"calls.c", calls, strlen(calls)}};
        result = build_submission(exercise, sources, 2, BUILD_PLAIN, build, err);
    }
    free(reference);
    free(once);
    free(calls);
    return result;
}

static int build_subject(const struct subject *subject, const struct exercise *exercise,
                         const char *root, struct build *build, struct error *err)
{
    char path[PATH_MAX], *text;
    size_t bytes;
    snprintf(path, sizeof path, "%s/tests/%s", root, subject->path);
    if (file_read(path, 1 << 20, &text, &bytes, err) != 0)
        return -1;
    struct source source = {"answer.c", text, bytes};
    int result = subject->repeats > 0
                     ? build_repeated(subject, exercise, root, text, build, err)
                     : build_submission(exercise, &source, 1, BUILD_PLAIN, build, err);
    if (result == 0 && build->refusal.refused)
        result = error_set(err, "%s does not build: %s %.300s", path, build->refusal.message.en,
                           build->diagnostics);
    free(text);
    return result;
}

static int try_subject(const struct subject *subject, int decisions, int *wrong, struct error *err)
{
    const char *root = project_root(err);
    struct exercise *exercises = NULL;
    struct yardstick yardstick;
    struct trial trial = {0};
    int count;
    if (!root || exercises_read(root, &exercises, &count, err) != 0)
        return -1;
    int result = yardstick_make(&yardstick, exercise_find(exercises, count, subject->exercise),
                                seeds_of_class(SEED_PUBLISHED), true, err);
    if (result == 0) {
        trial.yardstick = &yardstick;
        result = build_subject(subject, yardstick.inputs.exercise, root, &trial.build, err);
        if (result == 0)
            result = decide(&trial, subject, decisions, wrong, err);
        build_release(&trial.build);
    }
    yardstick_release(&yardstick);
    free(exercises);
    return result;
}

int main(int argc, char **argv)
{
    int decisions = argc > 1 ? atoi(argv[1]) : 1000, wrong = 0, result = 0;
    int load = argc > 2 ? atoi(argv[2]) : 2 * (int)sysconf(_SC_NPROCESSORS_ONLN);
    int each = (decisions + 2 * REPEATED_COUNT - 1) / (2 * REPEATED_COUNT);
    struct error err = {0};
    if (decisions < 1 || load < 0) {
        fprintf(stderr, "usage: two_witness [DECISIONS [BUSY]]\n");
        return 64;
    }
    start_busy(load);
    printf("%d busy processes beside. Wrong decisions at true ratio over bound:\n\n"
           "| submission | true ratio |",
           busy_count);
    for (int d = 0; d < DISTANCE_COUNT; d++)
        printf(" %.1f |", distances[d].factor);
    puts("\n|---|---|---|---|---|---|");
    for (int i = 0; result == 0 && i < SUBJECT_COUNT; i++)
        result =
            try_subject(&subjects[i], subjects[i].repeats > 0 ? each : each / 5 + 1, &wrong, &err);
    stop_busy();
    if (result != 0) {
        fprintf(stderr, "two_witness: %s\n", err.text);
        return 2;
    }
    printf("\n%d decisions on the reference's own work at 0.7 and 1.5: %d wrong\n",
           2 * each * REPEATED_COUNT, wrong);
    return wrong > 0;
}
