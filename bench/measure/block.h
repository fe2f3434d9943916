/* One block of a comparison: fresh processes of all programs that are compared, alive together and
 * measured in turns.
 *
 * Programs are started in an order that differs from block to block (pages and code lie where the
 * start order puts them); each operation is then sampled in rounds, A B C, C B A, A B C, ... (ABBA
 * for two), so that a slow moment hits all of them. Within a process the least sample counts. A
 * ratio is between two programs of the same block; blocks are the independent repetitions
 * (interval.h). */
#ifndef BENCH_MEASURE_BLOCK_H
#define BENCH_MEASURE_BLOCK_H

#include "bench/measure/worker.h"
#include "reference/base/error.h"

#include <stdbool.h>
#include <stdint.h>

enum { BLOCK_PROGRAMS_MAX = 24, BLOCK_OPERATIONS_MAX = 24, BLOCK_TEXT = 200 };

/* How fast the core runs when nobody slows it. Samples whose surroundings ran below 90 % of that
 * are dropped and tried again: a neighbour on the sibling hyperthread takes a third to a half. The
 * measure is the upper quartile of the recent speeds, not the best one, since short loops now and
 * then look faster than they are. Start with {0}. */
enum { CORE_WATCH_RECENT = 256 };
struct core_watch {
    double recent[CORE_WATCH_RECENT]; /* additions per ns, the last ones */
    int recent_count, next;
    double full_speed; /* their upper quartile */
    int64_t samples, dropped;
};

/* Looks at the core for some 30 ms, so that full_speed is known before the first sample. */
void core_watch_begin(struct core_watch *watch);

/* Whether a sample with these speeds before and after it counts; keeps the tally. */
bool core_watch_accepts(struct core_watch *watch, double before, double after);

struct block_time {
    double ns;  /* of one call: the least sample; 0: none */
    bool noisy; /* none was taken at full speed: the least of the dropped ones stands */
};

struct block_measure {
    char operation[40];
    struct block_time warm, cold;
    int samples, dropped;
    double warm_spent_ns, cold_spent_ns; /* in samples, those that were dropped too */
    struct worker_answer answer;         /* of block 0: it is told there, and nowhere else */
    char error[BLOCK_TEXT];              /* why there is no time; "" when there is */
};

struct block_result {
    char refused[BLOCK_TEXT]; /* the program refused the input, or died; "" when it did not */
    int measure_count;
    struct block_measure measures[BLOCK_OPERATIONS_MAX];
};

struct block_plan {
    const char *const *const *programs; /* argv of each */
    int program_count;                  /* 1 ... BLOCK_PROGRAMS_MAX */
    int number;                         /* of the block: decides the order of starting */
    int rounds, cold_rounds;            /* samples of each operation */
    int seconds;                        /* that one answer may take */
    const char *only; /* operations to measure, " a b c "; NULL: all that the programs have */
};

/* Runs the block.
 *
 * results  program_count of them
 * returns  0, or -1 and *err: no process could be made. A program that dies, hangs or refuses is a
 *          result, not an error. */
int block_run(const struct block_plan *plan, struct core_watch *watch, struct block_result *results,
              struct error *err) MUST_CHECK;

#endif
