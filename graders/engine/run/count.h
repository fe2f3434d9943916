/* Measures a submission on sized inputs: exact memory natively, exact work under callgrind.
 *
 * All sizes of a family share one process; every measured call is also a judged call. Counts repeat
 * bit for bit: same program name, arguments, empty environment, same libc variants. */
#ifndef GRADERS_ENGINE_RUN_COUNT_H
#define GRADERS_ENGINE_RUN_COUNT_H

#include "graders/engine/run/attempt.h"

/* How measuring a family ended. */
struct count_run {
    int done;             /* sizes measured, from `first` on */
    int64_t hidden_bytes; /* resident growth of the largest call that no claim explains; 0: none */
    bool hopeless;        /* stopped early: the cost is far beyond the reference's and rising */
    struct attempt failure; /* verdict PASSED when every call was right, else what went wrong */
};

/* Calls the plain program on the sized inputs first ... last of a family, natively.
 *
 * costs     [last + 1]; heap_peak_bytes, allocation_count and stack_bytes of the sizes are set
 * returns   0, or -1 and *err (a fault); release run->failure by attempt_release */
int count_memory(struct yardstick *yardstick, const struct build *build, int family, int first,
                 int last, struct cost *costs, struct count_run *run, struct error *err) MUST_CHECK;

/* The same under callgrind: counts are set.
 *
 * reference  costs of the reference at the same sizes, to stop early when hopeless; NULL: never
 * stop
 */
int count_work(struct yardstick *yardstick, const struct build *build, int family, int first,
               int last, const struct cost *reference, struct cost *costs, struct count_run *run,
               struct error *err) MUST_CHECK;

/* Whether valgrind can be used here. Returns true, or false and says why. */
bool count_available(char *reason, size_t capacity);

#endif
