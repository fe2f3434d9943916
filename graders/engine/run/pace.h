/* Paired runs of a submission and the reference, for the second witness of speed.
 *
 * Both wait in boxes of their own, pinned to one CPU together with the engine, so that their CPU
 * clocks are exact when the engine reads them. Each pair gets the same fresh mesh; all CPU charged
 * between two readings counts, whatever the program did meanwhile. */
#ifndef GRADERS_ENGINE_RUN_PACE_H
#define GRADERS_ENGINE_RUN_PACE_H

#include "graders/engine/run/series.h"
#include "graders/engine/run/trial.h"

#include <sched.h>

struct pace {
    struct trial *trial;
    int family, size_index;
    struct series reference, submission;
    struct input fresh; /* the mesh of the pair */
    uint64_t seed;      /* of the first pair's mesh; comes from the class's seed, and differs from
                           those of the meshes on which work is counted: what a submission remembers
                           or brings along is of no use */
    uint64_t pairs;     /* run so far */
    bool right;         /* whether the last answer was right */
    bool gone;          /* the submission did not answer; no further pair */
    bool spent;         /* because its budget is: that tells nothing of its speed */
    struct attempt failure; /* the first wrong answer; .verdict is VERDICT_PASSED without one */
    cpu_set_t before;       /* where the engine may run otherwise */
};

/* The size for paired runs: the largest there is. Short calls are charged mostly for what happens
 * around them: at 8,192 triangles and 33 us a call, other work on the machine moved the median
 * ratio of one and the same submission between 11 and 14. */
int pace_size_index(const struct yardstick *yardstick);

/* Starts both programs and runs three pairs to warm up: as many whatever the clock says, so that
 * whether these answers are right may decide a verdict. The trial must be built; it is borrowed.
 * Returns 0, or -1 and *err: a fault. pace_end must follow in any case. */
int pace_start(struct pace *pace, struct trial *trial, int family, int size_index,
               struct error *err) MUST_CHECK;

/* One pair, while not pace->gone.
 *
 * ratio    gets CPU time of the submission over that of the reference, 0 when it cannot be told
 * returns  0, or -1 and *err: a fault */
int pace_pair(struct pace *pace, double *ratio, struct error *err) MUST_CHECK;

/* Ends both programs and lets the engine run where it could before. Returns 0, or -1 and *err. */
int pace_end(struct pace *pace, struct error *err) MUST_CHECK;

/* The second witness of speed: is the charged CPU time of this submission above `bound` times the
 * reference's, by paired runs on the same CPU? Decided by a sequential sign test. */
int pace_is_slower(struct trial *trial, int family, int size_index, double bound, bool *slower,
                   struct error *err) MUST_CHECK;

/* The same question about a bound that no honest submission comes near, asked of every submission:
 * a lead of three pairs within it answers no. One pair would not do: beside other work a single run
 * of the reference is at times charged six times what the others are, and of nine pairs that is one
 * too often. The meshes are others than those that are counted.
 *
 * denied   gets whether the time is above the bound, or the submission did not answer
 * failure  gets a wrong answer to one of the first three meshes, or one whose verdict is
 *          VERDICT_PASSED; attempt_release must follow */
int pace_time_denies(struct trial *trial, int family, int size_index, double bound, bool *denied,
                     struct attempt *failure, struct error *err) MUST_CHECK;

#endif
