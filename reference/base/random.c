/* Seeded pseudo-random numbers; see random.h. */
#include "reference/base/random.h"

static uint64_t splitmix64(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

void random_init(struct random *rng, uint64_t seed)
{
    for (int i = 0; i < 4; i++)
        rng->state[i] = splitmix64(&seed);
}

static uint64_t rotate_left(uint64_t x, int bits)
{
    return (x << bits) | (x >> (64 - bits));
}

uint64_t random_next(struct random *rng)
{
    uint64_t *s = rng->state;
    uint64_t result = rotate_left(s[1] * 5, 7) * 9;
    uint64_t t = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = rotate_left(s[3], 45);
    return result;
}

uint64_t random_below(struct random *rng, uint64_t bound)
{
    /* The values under 2^64 mod bound would make small results likelier: draw again. */
    uint64_t surplus = (0 - bound) % bound;
    uint64_t bits = random_next(rng);
    while (bits < surplus)
        bits = random_next(rng);
    return bits % bound;
}

double random_real(struct random *rng)
{
    return (double)(random_next(rng) >> 11) * 0x1p-53;
}

float random_float(struct random *rng, float low, float high)
{
    return (float)((double)low + ((double)high - (double)low) * random_real(rng));
}

void random_permutation(struct random *rng, int32_t *order, int32_t count)
{
    /* Fisher and Yates, inside out: each number goes to a random place among those before it. */
    for (int32_t i = 0; i < count; i++) {
        int32_t j = (int32_t)random_below(rng, (uint64_t)i + 1);
        order[i] = i;
        order[i] = order[j];
        order[j] = i;
    }
}
