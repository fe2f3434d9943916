/* Clocks, and how fast the core runs just now; see clock.h. */
#include "bench/measure/clock.h"

#include <time.h>

static int64_t read_clock(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

int64_t clock_thread_cpu_ns(void)
{
    return read_clock(CLOCK_THREAD_CPUTIME_ID);
}

int64_t clock_wall_ns(void)
{
    return read_clock(CLOCK_MONOTONIC);
}

double clock_core_speed(int64_t rounds)
{
    uint64_t a = 1, b = 2, c = 3, d = 4, e = 5, f = 6, g = 7, h = 8;
    int64_t start = clock_thread_cpu_ns();
    for (int64_t i = 0; i < rounds; i++) {
        a += 3, b += 5, c += 7, d += 9, e += 11, f += 13, g += 15, h += 17;
        /* the compiler must not know the sums, or it would multiply instead */
        __asm__ volatile("" : "+r"(a), "+r"(b), "+r"(c), "+r"(d));
        __asm__ volatile("" : "+r"(e), "+r"(f), "+r"(g), "+r"(h));
    }
    int64_t elapsed_ns = clock_thread_cpu_ns() - start;
    return elapsed_ns > 0 ? 8.0 * (double)rounds / (double)elapsed_ns : 0;
}
