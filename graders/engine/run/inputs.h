/* The inputs of one exercise: those of the judge's cases, and those of any size on which growth, work
 * and memory are measured.
 *
 * Each is made when it is first asked for, and is then sealed memory that boxes can only read. All
 * submissions of a class share them (forked workers inherit what is made). */
#ifndef GRADERS_ENGINE_RUN_INPUTS_H
#define GRADERS_ENGINE_RUN_INPUTS_H

#include "graders/engine/base/exercise.h"
#include "graders/engine/run/region.h"
#include "graders/library/judge.h"

#include <limits.h>

struct input {
    struct region region;
    size_t bytes;        /* used of the region; 0: not made */
    size_t answer_bound; /* most bytes of an answer */
    size_t weight;       /* bytes, or memory that it makes a program take: judge_input_weight */
};

enum { SIZES_MAX = 16, EXTRA_DOUBLINGS = 2 /* when the first sizes leave the growth undecided */ };

/* The seeds of a class. A number of 1 or more gives the cases that are not public seeds of their
 * own, which nobody knows beforehand: tables of answers or orders that fit the published seeds gain
 * nothing. The same number gives the same meshes.
 *
 * The sizes on which work and memory are measured, and the meshes of these sizes, are drawn, too: by
 * the class's number, or at home, where the cases are the published ones, by one that is new each
 * time. What is fast on some sizes only is then slow on others. */
enum { SEED_PUBLISHED = 0 /* the seeds in the judges' source: what `check` uses at home */ };

struct seeds {
    uint32_t cases; /* SEED_PUBLISHED, or the class's own */
    uint32_t sizes; /* the class's own, or one of the day */
};

/* Both by one number. */
struct seeds seeds_of_class(uint32_t number);

struct inputs {
    const struct exercise *exercise;
    const struct judge *judge; /* &seeded */
    struct judge seeded;       /* the exercise's judge, with the cases below */
    struct judge_case *seeded_cases;
    char models[PATH_MAX];
    struct input *cases;          /* judge->case_count */
    int family_count, size_count; /* 0 when no growth is checked; size_count before extensions */
    int64_t sizes[FAMILIES_MAX][SIZES_MAX]; /* size_count, then EXTRA_DOUBLINGS more; drawn */
    int64_t told_sizes[SIZES_MAX];          /* about the same: what people are told */
    struct input sized[FAMILIES_MAX][SIZES_MAX];
    uint64_t seed; /* of the sized inputs */
    struct seeds seeds;
};

/* The index of the size beyond those that are counted, about twice the largest: memory and time are
 * looked at there, too. */
int inputs_beyond(const struct inputs *inputs);

/* Gets ready; nothing is made yet.
 *
 * exercise   borrowed for the inputs' life
 * returns    0, or -1 and *err (a fault: the exercise is not sound, no memory); inputs_release must
 *            follow in both cases */
int inputs_prepare(struct inputs *inputs, const struct exercise *exercise, struct seeds seeds,
                   struct error *err) MUST_CHECK;

/* The input of a case. */
int inputs_case(struct inputs *inputs, size_t index, const struct input **input,
                struct error *err) MUST_CHECK;

/* The input of a family at a size. */
int inputs_sized(struct inputs *inputs, int family, int size_index, const struct input **input,
                 struct error *err) MUST_CHECK;

void inputs_release(struct inputs *inputs);

#endif
