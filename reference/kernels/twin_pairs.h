/* Pairs of twins on their way from the rows, where they are found, to the table of twins, where
 * their places are all over when the mesh is scattered: held back a little, so that those places
 * can be asked for in time. */
#ifndef REFERENCE_KERNELS_TWIN_PAIRS_H
#define REFERENCE_KERNELS_TWIN_PAIRS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { TWIN_PAIRS = 512 };

struct twin_pairs {
    size_t count;
    int32_t *twin;
    uint32_t one[TWIN_PAIRS + 32], other[TWIN_PAIRS + 32]; /* a row more than TWIN_PAIRS */
};

/* Enters the pairs that are full, or all of them at the end. */
static inline void twin_pairs_flush(struct twin_pairs *pairs)
{
    enum { AHEAD = 16 };
    int32_t *twin = pairs->twin;
    for (size_t k = 0; k < pairs->count; k++) {
        if (k + AHEAD < pairs->count) {
            __builtin_prefetch(twin + pairs->one[k + AHEAD], 1);
            __builtin_prefetch(twin + pairs->other[k + AHEAD], 1);
        }
        twin[pairs->one[k]] = (int32_t)pairs->other[k];
        twin[pairs->other[k]] = (int32_t)pairs->one[k];
    }
    pairs->count = 0;
}

#endif
