/* What bench/preload/allocations.c counts when it is preloaded into a program. */
#ifndef BENCH_MEASURE_ALLOCATION_COUNTS_H
#define BENCH_MEASURE_ALLOCATION_COUNTS_H

#include <stdint.h>

struct allocation_counts {
    int64_t allocations;     /* calls that gave memory */
    int64_t allocated_bytes; /* usable bytes of all of them */
    int64_t live_bytes;      /* now */
    int64_t peak_bytes; /* highest of live_bytes; may be set back to live_bytes by the reader */
};

/* The name under which the preloaded library shows its counts (dlsym). */
#define ALLOCATION_COUNTS_SYMBOL "meshgrade_allocation_counts"

#endif
