/* Work split over threads, for the threads variants. */
#ifndef REFERENCE_KERNELS_THREADS_H
#define REFERENCE_KERNELS_THREADS_H

#include <stdint.h>

/* Calls work(job, 0) ... work(job, thread_count - 1), each on a thread of its own (the last one is
 * the caller's), and returns when all have. What cannot get a thread is called by the caller, one
 * after the other: work must not wait for other work. thread_count is 1 ... KERNEL_MOST_THREADS. */
void run_on_threads(int thread_count, void (*work)(void *job, int index), void *job);

/* Begin of share `index` of 0 ... total - 1 among thread_count; share thread_count begins at total.
 */
static inline int32_t share_begin(int32_t total, int index, int thread_count)
{
    return (int32_t)((int64_t)total * index / thread_count);
}

/* How many threads the work on so many triangles is worth, at most thread_count. A thread costs
 * some 20 microseconds to start. */
int threads_worth(int32_t triangle_count);

#endif
