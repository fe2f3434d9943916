/* What a bench run measures: on which meshes which programs are compared. */
#ifndef BENCH_COMPARE_PLAN_H
#define BENCH_COMPARE_PLAN_H

#include "bench/compare/meshes.h"
#include "bench/measure/block.h"
#include "reference/base/error.h"

#include <limits.h>
#include <stdbool.h>

/* What can be asked for; bits. */
enum bench_what {
    BENCH_REPRESENTATIONS = 1,
    BENCH_KERNELS = 2,
    BENCH_PAPER = 4,
    BENCH_READERS = 8,
    BENCH_CLAIMS = 16,
    BENCH_ALL = 31
};

/* The bit of that name, 0 when there is none; and the name of one bit. */
unsigned bench_what_find(const char *name);
const char *bench_what_name(unsigned what);

enum contender_kind {
    CONTENDER_REPRESENTATION,
    CONTENDER_KERNEL,
    CONTENDER_READER,
    CONTENDER_PEER
};

/* A program that takes part: ours as a worker, or a peer's. */
struct contender {
    enum contender_kind kind;
    char name[40];   /* "half-edge", "avx2", "openmesh": unique within a job */
    char title[64];  /* for people */
    char worker[64]; /* our worker's name (subjects.h); "" for a peer */
    char program[PATH_MAX];
    int thread_count;
};

enum { JOB_NAME = 96 };

/* One mesh, on which programs are compared in blocks. */
struct job {
    unsigned what;
    char name[JOB_NAME]; /* "kernels torus-100k-scrambled": also in the journal */
    struct bench_mesh mesh;
    int blocks, rounds, cold_rounds;
    const char *only; /* operations, " a b c "; NULL: all that the contenders have; static */
    struct contender contenders[BLOCK_PROGRAMS_MAX];
    int contender_count;
    int baseline; /* the contender that ratios are to */
};

struct plan {
    struct job *jobs;
    int job_count;
    int blocks_at_once; /* of a job before the next one begins: 1 gives a little of everything
                           first, all of them finishes what was begun */
};

struct plan_wish {
    unsigned what; /* enum bench_what bits */
    bool quick, thorough, peers;
    const char *mesh;         /* only this one, by name; NULL: the usual ones */
    const char *subject;      /* only contenders whose name has this in it, and the baseline */
    int blocks;               /* 0: as planned: 6, thorough 12 */
    const char *program;      /* that serves our workers */
    const char *peers_folder; /* where peers' programs stand */
};

/* Makes the plan; the caller owns it (plan_release). Peers that were not built are left out.
 * Returns 0, or -1 and *err: no such mesh, nothing to measure. */
int plan_make(struct plan *plan, const struct plan_wish *wish, struct error *err) MUST_CHECK;
void plan_release(struct plan *plan);

#endif
