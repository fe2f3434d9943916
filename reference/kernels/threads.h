/* Work split over threads, for the threads variants. */
#ifndef REFERENCE_KERNELS_THREADS_H
#define REFERENCE_KERNELS_THREADS_H

#include <stdbool.h>
#include <stdint.h>

/* Calls work(job, 0) ... work(job, thread_count - 1), each on a thread of its own (the last one is
 * the caller's), and returns when all have. If a thread cannot be started, the caller runs its
 * share itself: work must not wait for other work. thread_count is 1 ... KERNEL_MOST_THREADS. */
void threads_run(int thread_count, void (*work)(void *job, int index), void *job);

/* Begin of share `index` of 0 ... total - 1 among thread_count; share thread_count begins at total.
 */
static inline int32_t share_begin(int32_t total, int index, int thread_count)
{
    return (int32_t)((int64_t)total * index / thread_count);
}

/* How many threads the work on so many triangles is worth, at most thread_count. A thread costs
 * some 20 microseconds to start. */
int threads_worth(int32_t triangle_count);

/* A thread's share of the vertices: what it alone writes. */
struct owner {
    uint32_t first, count;
};

static inline struct owner owner_of_share(int32_t vertex_count, int index, int thread_count)
{
    uint32_t first = (uint32_t)share_begin(vertex_count, index, thread_count);
    uint32_t end = (uint32_t)share_begin(vertex_count, index + 1, thread_count);
    return (struct owner){first, end - first};
}

static inline bool owns(struct owner owner, int32_t vertex)
{
    return (uint32_t)vertex - owner.first < owner.count;
}

/* Triangles that a thread looks over together. */
enum { BLOCK_TRIANGLES = 16 };

/* Whether none of the vertices from the least to the greatest of a block's is owned: so a thread
 * skips most of what others own, where the order of the triangles follows that of the vertices. */
static inline bool owns_none_between(struct owner owner, const int32_t *t, int32_t triangle_count)
{
    int32_t least = t[0], greatest = t[0];
    for (int32_t k = 1; k < 3 * triangle_count; k++) {
        least = t[k] < least ? t[k] : least;
        greatest = t[k] > greatest ? t[k] : greatest;
    }
    return (uint32_t)greatest < owner.first || (uint32_t)least >= owner.first + owner.count;
}

#endif
