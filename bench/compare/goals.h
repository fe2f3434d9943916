/* What the reference kernels and readers are meant to reach, and whether a run shows it.
 *
 * A goal is about a kernel on a mesh. Its parts: how many times the fastest peer's time is ours at
 * least, warm and cold; what the plain variant takes at most of the vector one's time; how many
 * indices strips have at most of the peer's. Each part has a verdict:
 *
 *   met        the whole interval of the ratio keeps the goal
 *   missed     the whole interval breaks it
 *   undecided  neither; `why` says: the interval contains the goal, it does so being too noisy,
 *              there are too few blocks for 95 % of confidence, or no peer with the right answer
 *              took part
 *
 * and the row that of its parts: missed when one is, else undecided when one is. */
#ifndef BENCH_COMPARE_GOALS_H
#define BENCH_COMPARE_GOALS_H

#include <jansson.h>

/* What is asked of one kernel; 0 and NULL: nothing. */
struct goal {
    const char *operation;
    const char *order;  /* of the meshes it is about; NULL: those of no entry before it */
    const char *orders; /* the same in words, "" for all */
    double warm, cold;  /* the peer's time over ours, at least */
    double plain;       /* plain over vector, at most */
    double indices;     /* ours over the peer's, at most */
    const char *peer;   /* against this one alone; NULL: the fastest */
    const char *reason;
};

/* All of them; ends with a NULL operation. The first entry that fits a row is its goal. */
extern const struct goal goals_table[];

/* The entry for an operation on meshes of that order, or NULL. */
const struct goal *goals_find(const char *operation, const char *order);

/* The goals of bench.json (README.md) for its rows: one for each kernel and mesh that we were
 * measured on, in the order of goals_table. Only rows are read. The caller owns the array; NULL:
 * out of memory. */
json_t *goals_of(const json_t *rows);

#endif
