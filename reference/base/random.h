/* Pseudo-random numbers with an explicit seed: xoshiro256** by Blackman and Vigna (2018), seeded
 * through splitmix64. The same seed gives the same sequence on every machine. Not for secrets. */
#ifndef REFERENCE_BASE_RANDOM_H
#define REFERENCE_BASE_RANDOM_H

#include <stdint.h>

struct random {
    uint64_t state[4]; /* never all zero; filled by random_init */
};

/* Starts the sequence of a seed; every seed, 0 too, is good. */
void random_init(struct random *rng, uint64_t seed);

/* Next 64 bits. */
uint64_t random_next(struct random *rng);

/* Next integer of 0 ... bound - 1, each equally likely (by rejection); bound >= 1. */
uint64_t random_below(struct random *rng, uint64_t bound);

/* Next real of [0, 1), a multiple of 2^-53. */
double random_real(struct random *rng);

/* Next binary32 of [low, high]. */
float random_float(struct random *rng, float low, float high);

/* Fills order[0 ... count - 1] with the numbers 0 ... count - 1 in a random order, each order
 * equally likely. order may be NULL when count is 0. */
void random_permutation(struct random *rng, int32_t *order, int32_t count);

#endif
