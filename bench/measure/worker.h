/* A program that lets itself be measured: it holds one subject (a data structure, a kernel, a
 * library) with its operations, and does what it is told, line by line:
 *
 *     told              answers
 *     (at the start)    ready OPERATION...          or    refused WHY
 *     warm OPERATION    sample NS_PER_CALL CALLS SPEED_BEFORE SPEED_AFTER
 *     cold OPERATION    the same, one call on pages that were never touched
 *     answer OPERATION  answer HASH VALUE SCALE TOLERANCE [NAME=NUMBER...]
 *     count OPERATION   counted ALLOCATIONS ALLOCATED_BYTES PEAK_BYTES LIVE_BYTES     (-1: not
 * known) (end of input)    ends
 *
 * or `error WHY`. The side that asks (block.h) decides which process runs when, so that programs
 * can be measured in turns. SPEED is clock_core_speed right before and after (clock.h). A warm sample
 * takes as many calls as fill 0.3 ms, after one call that is not measured; time is CPU time of the
 * thread, or wall time of subjects that use several threads.
 *
 * `count` makes one warm call between two toggles of callgrind and then dumps, labelled with the
 * operation; allocations are known where build/bench-allocations.so is preloaded. */
#ifndef BENCH_MEASURE_WORKER_H
#define BENCH_MEASURE_WORKER_H

#include "reference/base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Memory for output and scratch of operations. It is on huge pages where the kernel gives them, and
 * becomes fresh 4 KiB pages, at the same address, for a cold call. Start with {0}. */
enum { WORKER_PIECES_MAX = 24 };
struct worker_memory {
    struct {
        void *start;
        size_t bytes;
    } pieces[WORKER_PIECES_MAX];
    int piece_count;
    bool is_cold; /* the pages are those of a cold call */
};

/* A piece of zeroed memory that lives until worker_memory_release; NULL and *err when there is no
 * more. bytes 0 gives a valid address. Its contents are lost whenever a cold call follows. */
void *worker_memory_take(struct worker_memory *memory, size_t bytes, struct error *err);
void worker_memory_release(struct worker_memory *memory);

/* What an operation computed, in a form that can be compared with another program's. */
struct worker_answer {
    uint64_t hash;       /* of what must be equal exactly, order-free where order is free */
    double value, scale; /* must be equal within tolerance * scale; scale 0: there is no value */
    double tolerance;
    char facts[256]; /* " name=number name=number": what is worth telling; no other blanks */
};

/* Adds a fact to the answer. */
void worker_fact(struct worker_answer *answer, const char *name, double number);

struct worker_operation {
    const char *name;
    void *context;                                /* handed to each of the following */
    int (*run)(void *context, struct error *err); /* what is measured */
    void (*reset)(void *context);                 /* after each call, not measured; NULL: nothing */
    /* What the last run left (it was not reset since). NULL: nothing to compare. */
    int (*answer)(void *context, struct worker_answer *answer, struct error *err);
};

struct worker_subject {
    const struct worker_operation *operations;
    int operation_count;
    int thread_count; /* above 1: wall time counts */
    struct worker_memory *memory;
};

/* Serves until the end of `in`. Returns 0, or -1 and *err when a line is not understood. */
int worker_serve(const struct worker_subject *subject, FILE *in, FILE *out,
                 struct error *err) MUST_CHECK;

/* Says `refused` instead: the subject cannot be measured on this input. */
void worker_refuse(FILE *out, const char *why);

/* Keeps freed memory for the next call, so that warm calls of programs that allocate find touched
 * pages too; a cold call gives them back to the system first. To be called at the start. */
void worker_keep_memory(void);

#ifdef __cplusplus
}
#endif

#endif
