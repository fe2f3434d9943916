/* The yardstick of one exercise: its inputs, and what the reference needs for them on this machine.
 *
 * Made once a run and shared by all submissions (forked workers inherit it): the reference is
 * built, run and counted once. Inputs are sealed memory that boxes can only read. */
#ifndef GRADERS_ENGINE_RUN_YARDSTICK_H
#define GRADERS_ENGINE_RUN_YARDSTICK_H

#include "bench/measure/callgrind.h"
#include "bench/measure/growth.h"
#include "graders/engine/base/exercise.h"
#include "graders/engine/build/build.h"
#include "graders/engine/run/region.h"
#include "graders/library/judge.h"

struct input {
    struct region region;
    size_t bytes;        /* used of the region; 0: not made */
    size_t answer_bound; /* most bytes of an answer */
    size_t weight;       /* bytes, or memory that it makes a program take: judge_input_weight */
};

/* What one call on a sized input cost. */
struct cost {
    bool counted;
    struct callgrind_counts counts; /* without misses at the sizes that are counted only in doubt */
    int64_t beside_instructions;    /* of the process, around the call */
    int64_t heap_peak_bytes;
    int64_t allocation_count;
    int64_t stack_bytes;
};

enum { SIZES_MAX = 16 };

/* Which probes this machine has. A probe that lacks is reported, and no mark rests on it. */
struct probes {
    bool valgrind;
    struct phrase no_valgrind; /* why not */
};

/* The seeds of a class. A number of 1 or more gives the cases that are not public, and the meshes
 * on which work is counted, seeds of their own, which nobody knows beforehand: tables of answers or
 * orders that fit the published seeds gain nothing. The same number gives the same meshes. */
enum { SEED_PUBLISHED = 0 /* the seeds in the judges' source: what `check` uses at home */ };

struct yardstick {
    const struct exercise *exercise;
    const struct judge *judge; /* &seeded */
    struct judge seeded;       /* the exercise's judge, with the cases below */
    struct judge_case *seeded_cases;
    struct probes probes;
    char models[PATH_MAX];
    struct build reference;
    struct input *cases;          /* judge->case_count, made when first asked for */
    int64_t *reference_cpu_ns;    /* of each case, 0: not run yet */
    int family_count, size_count; /* 0 when no growth is checked; size_count before extensions */
    int64_t sizes[SIZES_MAX];     /* size_count, then two doublings more */
    struct input sized[FAMILIES_MAX][SIZES_MAX];
    struct cost costs[FAMILIES_MAX][SIZES_MAX]; /* of the reference */
    uint64_t seed;                              /* of the sized inputs */
    uint32_t class_seed;                        /* SEED_PUBLISHED or the class's own */
    bool quick;                                 /* made for `check --quick`: nothing is counted */
};

/* Builds and counts the reference.
 *
 * exercise   borrowed for the yardstick's life
 * class_seed SEED_PUBLISHED, or the class's own
 * quick      true: leave the counting out
 * returns    0, or -1 and *err (a fault: the reference must build, run and be accepted);
 *            yardstick_release must follow in both cases */
int yardstick_make(struct yardstick *yardstick, const struct exercise *exercise,
                   uint32_t class_seed, bool quick, struct error *err) MUST_CHECK;

/* The input of a case; makes it, and runs the reference on it, when that was not done yet. */
int yardstick_case(struct yardstick *yardstick, size_t index, const struct input **input,
                   struct error *err) MUST_CHECK;

/* Makes the inputs (and reference runs) of every case now, so that forked workers share them. */
int yardstick_make_cases(struct yardstick *yardstick, bool public_only,
                         struct error *err) MUST_CHECK;

/* The sized input of a family; makes it when that was not done yet. */
int yardstick_sized(struct yardstick *yardstick, int family, int size_index,
                    const struct input **input, struct error *err) MUST_CHECK;

enum { CPU_LIMIT_MULTIPLE = 20, CPU_LIMIT_LEAST_SECONDS = 1 };

/* CPU time that a submission may take for a case: a generous multiple of the reference's. */
int64_t yardstick_cpu_limit_ns(const struct yardstick *yardstick, size_t index);

void yardstick_release(struct yardstick *yardstick);

#endif
