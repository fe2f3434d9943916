/* The allocation shim: counts what the student's function asks for, to the byte, and by who asks.
 *
 * In the student's object malloc and its kin are renamed to functions of the shim (student_malloc
 * ...), in libc the link replaces them by others (ld --wrap): graders/engine/build/wrapped.h. What
 * libc keeps for itself, a buffer of stdin or the names of a time zone, is no leak of the student's
 * and is never refused to try him; but while it lives it is memory that the call takes. What libc
 * asks for on the student's behalf is his, who must give it back (on_behalf.c). Every block carries
 * a header of 16 bytes that tells its size and whose it is; the header is not counted. Under a sanitizer or memcheck, which bring
 * allocators of their own, the shim is absent (RUNNER_WITHOUT_SHIM) and every count stays zero. */
#ifndef GRADERS_RUNNER_SHIM_H
#define GRADERS_RUNNER_SHIM_H

#include <stdbool.h>
#include <stdint.h>

struct shim_counts {
    int64_t live_bytes; /* of blocks that this call or an earlier one allocated, libc's included */
    int64_t own_blocks; /* the student's only */
    int64_t peak_bytes; /* of live_bytes */
    int64_t allocation_count; /* of the student's requests */
    int64_t refused_count;
    int64_t bad_free_count;
    int64_t own_bytes; /* live, the student's only */
};
extern struct shim_counts shim_counts;

/* Counts anew. Blocks of earlier calls that are still there go on counting: what a function keeps
 * from call to call it does not get for nothing.
 *
 * limit_bytes         an allocation that would take live_bytes beyond gets NULL
 * failing_allocation  the student's how-manieth allocation from now gets NULL, 0: none */
void shim_begin(int64_t limit_bytes, int64_t failing_allocation);

/* Allocations from now on belong to no call: they are neither counted nor limited. Blocks of a call
 * that are freed later still leave live_bytes. */
void shim_end(void);

/* Whose blocks are that libc asks for from now on. */
enum shim_behalf {
    BEHALF_NONE, /* libc's own */
    BEHALF_ASKS, /* the student's: as if he had asked himself */
    BEHALF_TAKES /* the student's, too, but not refused to try him */
};

/* Returns what held before. */
enum shim_behalf shim_on_behalf(enum shim_behalf behalf);

#endif
