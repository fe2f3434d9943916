/* Clocks, and how fast the core runs just now. */
#ifndef BENCH_MEASURE_CLOCK_H
#define BENCH_MEASURE_CLOCK_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* CPU time of the calling thread, and monotonic wall time. clock_thread_cpu_ns costs some 200 ns (it
 * enters the kernel), wall_ns 25 ns. */
int64_t clock_thread_cpu_ns(void);
int64_t clock_wall_ns(void);

/* Runs `rounds` rounds of eight independent additions in registers (some 2 cycles a round) and
 * returns additions per nanosecond of thread CPU time. Memory plays no part, so only what slows the
 * core itself shows: a neighbour on the sibling hyperthread (down to half), a lower clock. */
double clock_core_speed(int64_t rounds);

/* Rounds of a bracket around a sample: about 0.1 ms. */
enum { CORE_SPEED_ROUNDS = 100000 };

#ifdef __cplusplus
}
#endif

#endif
