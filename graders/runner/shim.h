/* The allocation shim: counts what the student's function asks for, to the byte.
 *
 * The link replaces malloc and its kin by these (ld --wrap), in the student's object and in libc
 * alike. Every block carries a header of 16 bytes that tells its size and whether it belongs to the
 * measured call; the header is not counted. Under a sanitizer or memcheck, which bring
 * allocators of their own, the shim is absent (RUNNER_WITHOUT_SHIM) and every count stays zero. */
#ifndef GRADERS_RUNNER_SHIM_H
#define GRADERS_RUNNER_SHIM_H

#include <stdbool.h>
#include <stdint.h>

struct shim_counts {
    int64_t live_bytes; /* of blocks that this call or an earlier one allocated */
    int64_t live_blocks;
    int64_t peak_bytes;
    int64_t allocation_count;
    int64_t refused_count;
    int64_t bad_free_count;
};
extern struct shim_counts shim_counts;

/* Counts anew. Blocks of earlier calls that are still there go on counting: what a function keeps
 * from call to call it does not get for nothing.
 *
 * limit_bytes         an allocation that would take live_bytes beyond gets NULL
 * failing_allocation  the how-manieth allocation from now gets NULL, 0: none */
void shim_begin(int64_t limit_bytes, int64_t failing_allocation);

/* Allocations from now on belong to no call: they are neither counted nor limited. Blocks of a call
 * that are freed later still leave live_bytes. */
void shim_end(void);

#endif
