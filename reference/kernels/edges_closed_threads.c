/* Edge table of a closed mesh on threads: each counts the edges of its share of the triangles, then
 * writes them where those of the shares before end; see edges_closed.h. */
#include "reference/kernels/cpu.h"
#include "reference/kernels/edges_closed.h"
#include "reference/kernels/threads.h"

enum { COUNTS_A_LINE = 8, MOST_WRITTEN_BEHIND = 8 };

struct job {
    const struct mesh *mesh;
    const struct kernel *serial;
    int64_t (*count_edges)(const int32_t *triangles, int32_t triangle_count);
    int64_t *counts; /* one a cache line: of a share; later, of all shares before */
    int32_t *edges;
    int thread_count;
};

size_t edges_closed_threads_scratch_bytes(int64_t vertex_count, int64_t triangle_count)
{
    (void)vertex_count;
    (void)triangle_count;
    return (size_t)KERNEL_MOST_THREADS * COUNTS_A_LINE * sizeof(int64_t);
}

static struct mesh share_of(const struct job *job, int index)
{
    int32_t begin = share_begin(job->mesh->triangle_count, index, job->thread_count);
    int32_t end = share_begin(job->mesh->triangle_count, index + 1, job->thread_count);
    return (struct mesh){NULL, job->mesh->triangles + 3 * (size_t)begin, 0, end - begin};
}

static void count_share(void *argument, int index)
{
    const struct job *job = argument;
    struct mesh share = share_of(job, index);
    job->counts[COUNTS_A_LINE * index] = job->count_edges(share.triangles, share.triangle_count);
}

/* The serial kernels write up to a vector behind their last edge, where another thread's may stand
 * already: the last triangles, with as many edges, are written by the book. */
static void write_share(void *argument, int index)
{
    const struct job *job = argument;
    struct mesh share = share_of(job, index);
    int32_t *edges = job->edges + 2 * job->counts[COUNTS_A_LINE * index];
    int32_t all = share.triangle_count;
    int64_t spare = 0;
    while (spare < MOST_WRITTEN_BEHIND && share.triangle_count > 0) {
        share.triangle_count--;
        spare += edges_closed_count(share.triangles + 3 * (size_t)share.triangle_count, 1);
    }
    edges += 2 * job->serial->run(&share, NULL, edges);
    for (const int32_t *t = share.triangles + 3 * (size_t)share.triangle_count,
                       *stop = share.triangles + 3 * (size_t)all;
         t < stop; t += 3)
        for (int k = 0; k < 3; k++)
            if (t[k] < t[(k + 1) % 3]) {
                *edges++ = t[k];
                *edges++ = t[(k + 1) % 3];
            }
}

int64_t edges_closed_on_threads(const struct mesh *mesh, void *scratch, void *output,
                                int thread_count)
{
    struct job job = {
        mesh, kernel_find("edges-closed", NULL), edges_closed_count, scratch, output, thread_count};
    if (thread_count == 1)
        return job.serial->run(mesh, NULL, output);
#if defined(__x86_64__)
    if (cpu_has_avx512())
        job.count_edges = edges_closed_count_avx512;
    else if (cpu_has_avx2())
        job.count_edges = edges_closed_count_avx2;
#endif
    threads_run(thread_count, count_share, &job);
    int64_t total = 0;
    for (int k = 0; k < thread_count; k++) {
        int64_t count = job.counts[COUNTS_A_LINE * k];
        job.counts[COUNTS_A_LINE * k] = total;
        total += count;
    }
    threads_run(thread_count, write_share, &job);
    return total;
}
