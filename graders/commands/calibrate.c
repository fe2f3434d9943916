/* meshgrade calibrate: how noisy this machine is, by measuring each kernel against itself. */
#include "graders/commands/common.h"
#include "graders/commands/options.h"

#include "bench/compare/calibrate.h"
#include "graders/engine/base/files.h"

#include <jansson.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { USUAL_TRIALS = 20, QUICK_TRIALS = 4, MESHES = 2 };
static const char *const mesh_names[MESHES] = {"torus-10k-generated", "bunny-100k-scrambled"};
static const double FALSE_ALARM_GOAL = 0.05, WORST_GOAL = 0.07;

struct noise {
    struct calibration_row rows[MESHES * BLOCK_OPERATIONS_MAX];
    int count;
    int trials, false_alarms, too_noisy;
    double worst;
};

static void show_progress(void *context, int done, int planned)
{
    const char *mesh = context;
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r\033[K%s: block %d of %d", mesh, done + 1, planned);
}

static int measure(struct noise *noise, int trials, struct error *err)
{
    char program[PATH_MAX], folder[PATH_MAX], models[PATH_MAX], meshes[PATH_MAX + 8];
    const char *root = project_root(err);
    ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    if (!root)
        return -1;
    if (length <= 0)
        return error_set(err, "/proc/self/exe cannot be read: is /proc mounted?");
    program[length] = '\0';
    const char *scratch = getenv("TMPDIR");
    if (snprintf(folder, sizeof folder, "%s/meshgrade-calibrate-XXXXXX",
                 scratch && *scratch ? scratch : "/tmp") >= PATH_MAX ||
        snprintf(models, sizeof models, "%s/exercises/models", root) >= PATH_MAX)
        return error_set(err, "too long a path");
    if (!mkdtemp(folder))
        return error_set(err, "%s: no folder can be made there", folder);
    snprintf(meshes, sizeof meshes, "%s/meshes", folder);
    int result = mkdir(meshes, 0700) == 0 ? 0 : error_set(err, "%s: cannot be made", meshes);
    for (int i = 0; result == 0 && i < MESHES; i++) {
        char name[48];
        int count;
        snprintf(name, sizeof name, "%s", mesh_names[i]);
        struct calibration_wish wish = {.program = program,
                                        .folder = folder,
                                        .models = models,
                                        .worker = "kernels/plain",
                                        .trials = trials,
                                        .progress = show_progress,
                                        .context = name};
        result = bench_mesh_find(mesh_names[i], &wish.mesh, err);
        if (result == 0)
            result = calibrate(&wish, noise->rows + noise->count, &count, err);
        noise->count += result == 0 ? count : 0;
    }
    if (isatty(STDERR_FILENO))
        fputs("\r\033[K", stderr);
    folder_remove(folder);
    return result;
}

static void sum_up(struct noise *noise)
{
    for (int i = 0; i < noise->count; i++) {
        noise->trials += noise->rows[i].trials;
        noise->false_alarms += noise->rows[i].false_alarms;
        noise->too_noisy += noise->rows[i].too_noisy;
        noise->worst = fmax(noise->worst, noise->rows[i].worst);
    }
}

static double share(int part, int whole)
{
    return whole > 0 ? (double)part / whole : 0;
}

static void print_table(const struct noise *noise)
{
    printf("Each kernel against itself, %d fresh pairs a trial; the true ratio is 1.\n\n",
           CALIBRATION_BLOCKS_PER_TRIAL);
    printf("%-22s %-22s %6s %6s %6s %8s %7s %7s\n", "mesh", "kernel", "trials", "false", "noisy",
           "typical", "worst", "dropped");
    for (int i = 0; i < noise->count; i++) {
        const struct calibration_row *row = &noise->rows[i];
        printf("%-22s %-22s %6d %6d %6d %6.1f %% %5.1f %% %5.1f %%\n", row->mesh, row->operation,
               row->trials, row->false_alarms, row->too_noisy, 100 * row->typical, 100 * row->worst,
               100 * row->dropped_share);
    }
    double alarms = share(noise->false_alarms, noise->trials);
    printf(
        "\nfalse alarms %.1f %% of %d trials (goal: at most %.0f %%), worst estimate %.1f %% off "
        "(goal: %.0f %%),\n%d trials too noisy to say anything\n",
        100 * alarms, noise->trials, 100 * FALSE_ALARM_GOAL, 100 * noise->worst, 100 * WORST_GOAL,
        noise->too_noisy);
    puts(alarms <= FALSE_ALARM_GOAL && noise->worst <= WORST_GOAL
             ? "Comparisons on this machine can be trusted to that."
             : "This machine is noisier than the goals: read its comparisons with that in mind, or "
               "repeat when it is idle.");
}

static void print_json(const struct noise *noise)
{
    json_t *rows = json_array();
    for (int i = 0; i < noise->count; i++) {
        const struct calibration_row *row = &noise->rows[i];
        json_array_append_new(rows, json_pack("{s:s, s:s, s:i, s:i, s:i, s:f, s:f, s:f, s:f}",
                                              "mesh", row->mesh, "kernel", row->operation, "trials",
                                              row->trials, "false_alarms", row->false_alarms,
                                              "too_noisy", row->too_noisy, "typical_error",
                                              row->typical, "worst_error", row->worst,
                                              "dropped_share", row->dropped_share, "ns", row->ns));
    }
    json_t *whole =
        json_pack("{s:s, s:i, s:f, s:f, s:i, s:o}", "format", "meshgrade-calibration-1", "trials",
                  noise->trials, "false_alarm_share", share(noise->false_alarms, noise->trials),
                  "worst_error", noise->worst, "too_noisy", noise->too_noisy, "rows", rows);
    json_dumpf(whole, stdout, JSON_INDENT(2) | JSON_REAL_PRECISION(6));
    putchar('\n');
    json_decref(whole);
}

static int run_calibrate(int argc, char **argv)
{
    struct error err = {0};
    const char *trials_text = NULL;
    bool quick = false, json = false;
    const struct option_rule rules[] = {
        {"quick", 'q', NULL, "4 trials", NULL, &quick},
        {"trials", 0, "N", "of each kernel (20, at most 200)", &trials_text, NULL},
        {"json", 0, NULL, "print JSON", NULL, &json},
        {0}};
    int first = options_parse(&command_calibrate, rules, argc, argv);
    long trials =
        options_number("trials", trials_text, 1, quick ? (long)QUICK_TRIALS : (long)USUAL_TRIALS);
    if (first < 0 || trials < 0)
        return EXIT_USAGE;
    if (first < argc || trials > CALIBRATION_TRIALS_MAX) {
        fprintf(stderr, "meshgrade: calibrate takes no operands and at most %d trials\n",
                CALIBRATION_TRIALS_MAX);
        return EXIT_USAGE;
    }
    struct noise *noise = calloc(1, sizeof *noise);
    if (!noise)
        error_set(&err, "out of memory");
    int result = noise ? measure(noise, (int)trials, &err) : -1;
    if (result == 0) {
        sum_up(noise);
        json ? print_json(noise) : print_table(noise);
    }
    free(noise);
    return result == 0 ? EXIT_PASSED : report_fault(&err);
}

const struct command command_calibrate = {
    "calibrate", "", "this machine's own noise: each kernel measured against itself",
    run_calibrate};
