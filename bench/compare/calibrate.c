/* A/A measurements; see calibrate.h. */
#include "bench/compare/calibrate.h"

#include "bench/compare/run.h"
#include "bench/compare/snapshot.h"
#include "bench/measure/interval.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDES = 2, ROUNDS = 6, ANSWER_SECONDS = 120 };

/* The ratios of one trial, operation by operation. */
struct trial_ratios {
    double above[BLOCK_OPERATIONS_MAX][CALIBRATION_BLOCKS_PER_TRIAL];
    double below[BLOCK_OPERATIONS_MAX][CALIBRATION_BLOCKS_PER_TRIAL];
};

struct calibration {
    const struct calibration_wish *wish;
    char snapshot_path[PATH_MAX];
    struct core_watch watch;
    struct block_result results[SIDES];
    struct calibration_row *rows;
    int row_count;
    int64_t samples[BLOCK_OPERATIONS_MAX], dropped[BLOCK_OPERATIONS_MAX];
    double errors[BLOCK_OPERATIONS_MAX][CALIBRATION_TRIALS_MAX]; /* |ratio - 1| of usable trials */
};

static int make_snapshot(const struct calibration *c, struct error *err)
{
    struct snapshot counts;
    struct mesh mesh;
    if (snapshot_read_counts(c->snapshot_path, &counts, NULL) == 0)
        return 0;
    if (bench_mesh_make(&c->wish->mesh, c->wish->models, &mesh, err) != 0)
        return -1;
    int result = snapshot_write(c->snapshot_path, &mesh, err);
    mesh_release(&mesh);
    return result;
}

static int check_side(const struct calibration *c, const struct block_result *side,
                      struct error *err)
{
    if (side->refused[0])
        return error_set(err, "calibrate: %s refused: %s", c->wish->worker, side->refused);
    if (side->measure_count != c->results[0].measure_count)
        return error_set(err, "calibrate: %s has other operations each time", c->wish->worker);
    for (int i = 0; i < side->measure_count; i++)
        if (side->measures[i].error[0])
            return error_set(err, "calibrate: %s %s: %s", c->wish->worker,
                             side->measures[i].operation, side->measures[i].error);
    return 0;
}

static int run_block(struct calibration *c, int number, int at, struct trial_ratios *ratios,
                     struct error *err)
{
    char *paths[] = {c->snapshot_path};
    const char *const argv[] = {c->wish->program, "bench",  "--worker",
                                c->wish->worker,  paths[0], NULL};
    const char *const *const programs[SIDES] = {argv, argv};
    struct block_plan plan = {.programs = programs,
                              .program_count = SIDES,
                              .number = number,
                              .rounds = ROUNDS,
                              .seconds = ANSWER_SECONDS};
    if (block_run(&plan, &c->watch, c->results, err) != 0 ||
        check_side(c, &c->results[0], err) != 0 || check_side(c, &c->results[1], err) != 0)
        return -1;
    for (int i = 0; i < c->results[0].measure_count; i++) {
        const struct block_measure *a = &c->results[0].measures[i], *b = &c->results[1].measures[i];
        struct calibration_row *row = &c->rows[i];
        snprintf(row->operation, sizeof row->operation, "%s", a->operation);
        ratios->above[i][at] = a->warm.ns;
        ratios->below[i][at] = b->warm.ns;
        c->samples[i] += a->samples + b->samples;
        c->dropped[i] += a->dropped + b->dropped;
        row->ns = row->ns > 0 ? fmin(row->ns, fmin(a->warm.ns, b->warm.ns))
                              : fmin(a->warm.ns, b->warm.ns);
    }
    c->row_count = c->results[0].measure_count;
    return 0;
}

static void judge_trial(struct calibration *c, const struct trial_ratios *ratios)
{
    for (int i = 0; i < c->row_count; i++) {
        struct calibration_row *row = &c->rows[i];
        struct interval ratio =
            interval_of_ratios(ratios->above[i], ratios->below[i], CALIBRATION_BLOCKS_PER_TRIAL);
        row->trials++;
        if (interval_too_noisy(&ratio)) {
            row->too_noisy++;
            continue;
        }
        double error = fabs(ratio.median - 1);
        c->errors[i][row->trials - row->too_noisy - 1] = error;
        row->false_alarms += ratio.low > 1 || ratio.high < 1;
        row->worst = fmax(row->worst, error);
    }
}

static void finish(struct calibration *c)
{
    for (int i = 0; i < c->row_count; i++) {
        struct calibration_row *row = &c->rows[i];
        int usable = row->trials - row->too_noisy;
        double middle[INTERVAL_VALUES_MAX];
        int count = usable < INTERVAL_VALUES_MAX ? usable : INTERVAL_VALUES_MAX;
        for (int k = 0; k < count; k++)
            middle[k] = fmax(c->errors[i][(int64_t)k * usable / count], 1e-9);
        row->typical = count > 0 ? interval_of(middle, count).median : 0;
        row->dropped_share =
            c->samples[i] > 0 ? (double)c->dropped[i] / (double)(c->samples[i] + c->dropped[i]) : 0;
        bench_mesh_name(&c->wish->mesh, row->mesh, sizeof row->mesh);
    }
}

int calibrate(const struct calibration_wish *wish, struct calibration_row *rows, int *row_count,
              struct error *err)
{
    struct calibration *c = calloc(1, sizeof *c); /* too large for the stack */
    struct trial_ratios ratios;
    int result = 0, planned = wish->trials * CALIBRATION_BLOCKS_PER_TRIAL;
    *row_count = 0;
    if (!c)
        return error_set(err, "out of memory");
    c->wish = wish;
    c->rows = rows;
    memset(rows, 0, BLOCK_OPERATIONS_MAX * sizeof *rows);
    run_mesh_path(wish->folder, &wish->mesh, c->snapshot_path, sizeof c->snapshot_path);
    result = make_snapshot(c, err);
    core_watch_begin(&c->watch);
    for (int block = 0; result == 0 && block < planned; block++) {
        if (wish->progress)
            wish->progress(wish->context, block, planned);
        int at = block % CALIBRATION_BLOCKS_PER_TRIAL;
        result = run_block(c, block, at, &ratios, err);
        if (result == 0 && at == CALIBRATION_BLOCKS_PER_TRIAL - 1)
            judge_trial(c, &ratios);
    }
    finish(c);
    *row_count = c->row_count;
    free(c);
    return result;
}
