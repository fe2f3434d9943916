/* How fast this core copies memory: the limit that streaming kernels are held against. */
#ifndef BENCH_MEASURE_BANDWIDTH_H
#define BENCH_MEASURE_BANDWIDTH_H

#include "reference/base/error.h"

#include <stdint.h>

struct copy_bandwidth {
    int64_t working_set_bytes;   /* source and destination together */
    const char *method;          /* "memcpy", "non-temporal": the faster one; static */
    double gigabytes_per_second; /* read and written bytes count once each */
};

/* Copies half of the working set to the other half, touched before and on huge pages where the
 * kernel gives them: the best of `repetitions` by thread CPU time, each of at least 1 ms, with
 * memcpy and with stores that bypass the caches (where the machine has them).
 *
 * working_set_bytes  4096 ... 2^32
 * returns            0, or -1 and *err (out of memory) */
int copy_bandwidth_measure(int64_t working_set_bytes, int repetitions,
                           struct copy_bandwidth *bandwidth, struct error *err) MUST_CHECK;

/* The bandwidth of the entry whose working set is nearest (by ratio); 0 when count is 0. */
double copy_bandwidth_at(const struct copy_bandwidth *table, int count, int64_t working_set_bytes);

#endif
