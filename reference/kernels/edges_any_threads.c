/* Edge table of any mesh on threads: each fills the rows of its share of the vertices, reading all
 * triangles; counts their edges; and writes them where those of the shares before end. See
 * edges_any.h. */
#include "reference/kernels/cpu.h"
#include "reference/kernels/edges_any.h"
#include "reference/kernels/neighbour_rows.h"
#include "reference/kernels/order.h"
#include "reference/kernels/threads.h"

enum { COUNTS_A_LINE = 8, ROWS_AT_ONCE = 64 };

struct job {
    const struct mesh *mesh;
    int32_t *(*put)(const struct neighbour_rows *rows, int32_t begin, int32_t end, int32_t *edges);
    struct neighbour_rows rows;
    int64_t *counts; /* one a cache line: of a share; later, of all shares before */
    int32_t *edges;
    int thread_count;
    bool is_scattered;
};

static size_t counts_bytes(void)
{
    return (size_t)KERNEL_MOST_THREADS * COUNTS_A_LINE * sizeof(int64_t);
}

size_t edges_any_threads_scratch_bytes(int64_t vertex_count, int64_t triangle_count)
{
    return counts_bytes() + neighbour_rows_bytes(vertex_count, triangle_count);
}

static void prefetch_owned(const struct neighbour_rows *rows, struct owner owner, const int32_t *t)
{
    struct sorted next = sort_corners(t);
    if (owns(owner, next.low))
        neighbour_rows_prefetch(rows, next.low);
    if (owns(owner, next.middle))
        neighbour_rows_prefetch(rows, next.middle);
}

static void fill_from_block(const struct job *job, struct neighbour_rows *rows, struct owner owner,
                            int32_t first, int32_t end)
{
    enum { AHEAD = 16 };
    const int32_t *t = job->mesh->triangles + 3 * (size_t)first;
    for (int32_t k = first; k < end; k++, t += 3) {
        if (job->is_scattered && job->mesh->triangle_count - k > AHEAD)
            prefetch_owned(rows, owner, t + 3 * AHEAD);
        struct sorted s = sort_corners(t);
        if (owns(owner, s.low))
            neighbour_rows_add_two(rows, s.low, s.middle, s.high);
        if (owns(owner, s.middle))
            neighbour_rows_add_one(rows, s.middle, s.high);
    }
}

static void fill_share(void *argument, int index)
{
    struct job *job = argument;
    struct owner owner = owner_of_share(job->mesh->vertex_count, index, job->thread_count);
    int32_t stop = job->mesh->triangle_count;
    for (int32_t k = 0; k < stop; k += BLOCK_TRIANGLES) {
        int32_t end = stop - k < BLOCK_TRIANGLES ? stop : k + BLOCK_TRIANGLES;
        if (job->is_scattered ||
            !owns_none_between(owner, job->mesh->triangles + 3 * (size_t)k, end - k))
            fill_from_block(job, &job->rows, owner, k, end);
    }
}

/* Puts the edges of a share aside, some rows at a time, as what is put may write a little too far;
 * copies them to `to` unless that is NULL. Returns how many they are. */
static int64_t put_share(const struct job *job, int index, int32_t *to)
{
    int32_t aside[2 * (ROWS_AT_ONCE + 1) * ROW_PLACES];
    int32_t stop = share_begin(job->mesh->vertex_count, index + 1, job->thread_count);
    int64_t count = 0;
    for (int32_t v = share_begin(job->mesh->vertex_count, index, job->thread_count); v < stop;
         v += ROWS_AT_ONCE) {
        int32_t end = stop - v < ROWS_AT_ONCE ? stop : v + ROWS_AT_ONCE;
        int64_t put = (job->put(&job->rows, v, end, aside) - aside) / 2;
        if (to)
            memcpy(to + 2 * count, aside, 2 * (size_t)put * sizeof *to);
        count += put;
    }
    return count;
}

static void count_share(void *argument, int index)
{
    const struct job *job = argument;
    job->counts[COUNTS_A_LINE * index] = put_share(job, index, NULL);
}

static void write_share(void *argument, int index)
{
    const struct job *job = argument;
    put_share(job, index, job->edges + 2 * job->counts[COUNTS_A_LINE * index]);
}

static int64_t put_on_threads(struct job *job)
{
    threads_run(job->thread_count, count_share, job);
    int64_t total = 0;
    for (int k = 0; k < job->thread_count; k++) {
        int64_t count = job->counts[COUNTS_A_LINE * k];
        job->counts[COUNTS_A_LINE * k] = total;
        total += count;
    }
    threads_run(job->thread_count, write_share, job);
    return total;
}

int64_t edges_any_on_threads(const struct mesh *mesh, void *scratch, void *output, int thread_count)
{
    char *rows = (char *)scratch + counts_bytes();
    if (thread_count == 1)
        return kernel_find("edges-any", NULL)->run(mesh, rows, output);
    struct job job = {.mesh = mesh,
                      .put = neighbour_rows_put_edges,
                      .rows = neighbour_rows_begin(rows, mesh),
                      .counts = scratch,
                      .edges = output,
                      .thread_count = thread_count,
                      .is_scattered = order_is_scattered(mesh)};
#if defined(__x86_64__)
    if (cpu_has_avx512())
        job.put = neighbour_rows_put_edges_avx512;
    else if (cpu_has_avx2())
        job.put = neighbour_rows_put_edges_avx2;
#endif
    threads_run(thread_count, fill_share, &job);
    neighbour_rows_sort_overflow(&job.rows);
    if (job.rows.overflow_count == 0)
        return put_on_threads(&job);
    /* Rows with an overflow share a table of what was met. */
    const int32_t *end = job.put(&job.rows, 0, mesh->vertex_count, output);
    return (end - (int32_t *)output) / 2;
}
