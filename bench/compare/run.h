/* A bench run: does the blocks of a plan one by one, keeps each in the journal, and goes round the
 * comparisons so that every one has its first block before any has its second. Stopped by time or
 * by a signal, it goes on the next time from the journal. */
#ifndef BENCH_COMPARE_RUN_H
#define BENCH_COMPARE_RUN_H

#include "bench/compare/journal.h"
#include "bench/compare/plan.h"

#include <signal.h>

struct run_progress {
    const char *doing; /* "torus-100k-scrambled: kernels" */
    int done, planned; /* blocks */
};

struct run_wish {
    const struct plan *plan;
    const char *folder; /* results; meshes go to its meshes/ */
    const char *models; /* exercises/models */
    double seconds;     /* begin no block that would end after that */
    bool counts;        /* also count instructions, misses and allocations, where valgrind is */
    void (*progress)(void *context, const struct run_progress *progress); /* NULL: none */
    void *context;
    const volatile sig_atomic_t *stop; /* not 0: end after this block; NULL: never */
};

/* Runs what is not yet in the journal. Returns 0, or -1 and *err. Whether all was done: see
 * run_is_complete. */
int run_plan(const struct run_wish *wish, struct journal *journal, struct error *err) MUST_CHECK;

bool run_is_complete(const struct plan *plan, const struct journal *journal);

/* Path of a mesh's snapshot below the results' folder. */
void run_mesh_path(const char *folder, const struct bench_mesh *mesh, char *path, int capacity);

#endif
