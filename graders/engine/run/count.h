/* Measures a submission on sized inputs: exact memory natively, exact work under callgrind.
 *
 * All sizes of a family share one process, and under callgrind, which takes its time to start, all
 * families; every measured call is also a judged call. Counts repeat bit for bit: same program
 * name, arguments, empty environment, same libc variants. */
#ifndef GRADERS_ENGINE_RUN_COUNT_H
#define GRADERS_ENGINE_RUN_COUNT_H

#include "bench/measure/callgrind.h"
#include "graders/engine/run/attempt.h"

/* What one call on a sized input cost. */
struct cost {
    bool counted;
    struct callgrind_counts counts; /* without misses at the sizes that are counted only in doubt */
    int64_t beside_instructions;    /* of the process, around the call */
    int64_t heap_peak_bytes;
    int64_t allocation_count;
    int64_t stack_bytes;
    int64_t access_count; /* calls of the functions that the exercise gives */
};

/* What to measure: sizes first ... last of the families first_family ... last_family. */
struct count_plan {
    int first_family, last_family;
    int first, last;
    bool leaps;          /* after four sizes go on with `last`, unless the work rises fast */
    bool stops_early;    /* leave out the larger sizes of a family whose work is far beyond the
                            reference's and rising */
    bool without_misses; /* count instructions alone: half the time */
    const struct cost
        *reference[FAMILIES_MAX]; /* what the reference's work costs at each size; NULL
                                                   while it is the reference that is counted */
};

/* How measuring ended. */
struct count_run {
    int end[FAMILIES_MAX];       /* the largest size of each family that was measured, and 1 */
    bool hopeless[FAMILIES_MAX]; /* stopped early */
    int64_t leaked_bytes, leaked_blocks; /* of the first call that left blocks; 0: none did */
    int leaking_size;                    /* its size index */
    int64_t hidden_bytes;   /* most that a call grew by and no claim explains; 0: none */
    int family, size_index; /* of the last call */
    struct attempt failure; /* verdict PASSED when every call was right, else what went wrong */
};

/* Calls the plain program on sized inputs, natively; of one family.
 *
 * costs     a family's [last + 1] each, may be NULL for those that are not measured;
 *           heap_peak_bytes, allocation_count and stack_bytes of the sizes are set
 * returns   0, or -1 and *err (a fault); release run->failure by attempt_release */
int count_memory(struct inputs *inputs, const struct build *build, const struct count_plan *plan,
                 struct cost *const costs[FAMILIES_MAX], struct count_run *run,
                 struct error *err) MUST_CHECK;

/* The same under callgrind: counts are set, and access_count. */
int count_work(struct inputs *inputs, const struct build *build, const struct count_plan *plan,
               struct cost *const costs[FAMILIES_MAX], struct count_run *run,
               struct error *err) MUST_CHECK;

/* Whether valgrind can be used here. Returns true, or false and why not. */
bool count_available(struct phrase *why_not);

#endif
