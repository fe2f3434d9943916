/* This machine's own noise: every kernel against itself (A/A), measured exactly as comparisons are.
 *
 * Two fresh processes of the same program take part in each block; `blocks_per_trial` blocks are a
 * trial, as in a bench run, and give a median ratio with its interval. The truth is 1. A false
 * alarm is an interval that leaves 1 out; the worst estimate is the median farthest from 1. The
 * sign test's interval of twelve blocks has a confidence of 96 %, so some 4 % of false alarms are
 * its due. */
#ifndef BENCH_COMPARE_CALIBRATE_H
#define BENCH_COMPARE_CALIBRATE_H

#include "bench/compare/meshes.h"
#include "bench/measure/block.h"

enum { CALIBRATION_BLOCKS_PER_TRIAL = 12, CALIBRATION_TRIALS_MAX = 200 };

struct calibration_row {
    char mesh[48], operation[40];
    int trials;
    int false_alarms;
    int too_noisy;        /* intervals that are too wide to say anything (interval.h) */
    double worst;         /* |ratio - 1| of the worst trial, without the too noisy ones */
    double typical;       /* median of |ratio - 1| */
    double dropped_share; /* of samples, because the core was slowed */
    double ns;            /* the least sample of all */
};

struct calibration_wish {
    const char *program; /* that serves our workers: this one */
    const char *folder;  /* for snapshots */
    const char *models;
    struct bench_mesh mesh;
    const char *worker;                                     /* "kernels/plain" */
    int trials;                                             /* 1 ... CALIBRATION_TRIALS_MAX */
    void (*progress)(void *context, int done, int planned); /* in blocks; NULL: none */
    void *context;
};

/* Measures on one mesh.
 *
 * rows     room for BLOCK_OPERATIONS_MAX, one an operation of the worker; *row_count gets how many
 * returns  0, or -1 and *err: no snapshot could be made, a worker refused or failed
 * Cost: trials * 12 blocks of some 0.3 s on 100,000 triangles */
int calibrate(const struct calibration_wish *wish, struct calibration_row *rows, int *row_count,
              struct error *err) MUST_CHECK;

#endif
