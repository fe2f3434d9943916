/* Twins on threads: each fills the rows of its share of the vertices, reading all triangles, and
 * matches them; see twins.h. No two rows hold the same side, so no two threads write the same twin.
 */
#include "reference/kernels/cpu.h"
#include "reference/kernels/order.h"
#include "reference/kernels/side_rows.h"
#include "reference/kernels/threads.h"
#include "reference/kernels/twins.h"

#include <string.h>

struct job {
    const struct mesh *mesh;
    void (*match)(const struct side_rows *rows, int32_t begin, int32_t end, int32_t *twin);
    struct side_rows rows;
    int32_t *twin;
    int thread_count;
    bool is_scattered;
};

static void prefetch_owned(struct filling f, struct owner owner, const int32_t *t)
{
    struct sorted next = sort_corners(t);
    if (owns(owner, next.low))
        filling_prefetch(f, next.low);
    if (owns(owner, next.middle))
        filling_prefetch(f, next.middle);
}

static void fill_from_block(const struct job *job, struct filling f, struct owner owner,
                            uint32_t first, uint32_t end)
{
    enum { AHEAD = 16 };
    const int32_t *t = job->mesh->triangles + 3 * (size_t)first;
    for (uint32_t k = first; k < end; k++, t += 3) {
        if (job->is_scattered && (uint32_t)job->mesh->triangle_count - k > AHEAD)
            prefetch_owned(f, owner, t + 3 * AHEAD);
        struct turned turned = turn_triangle(t, 3 * k);
        int32_t smaller = turned.b < turned.c ? turned.b : turned.c;
        if (owns(owner, turned.a))
            filling_add_two(f, turned.a, turned.ab, turned.ac);
        if (owns(owner, smaller))
            filling_add_one(f, smaller, turned.bc);
    }
}

static void fill_share(void *argument, int index)
{
    struct job *job = argument;
    struct owner owner = owner_of_share(job->mesh->vertex_count, index, job->thread_count);
    struct filling f = {job->rows.counts, job->rows.storeys, job->rows.row_count, &job->rows};
    int32_t stop = job->mesh->triangle_count;
    for (int32_t k = 0; k < stop; k += BLOCK_TRIANGLES) {
        int32_t end = stop - k < BLOCK_TRIANGLES ? stop : k + BLOCK_TRIANGLES;
        if (job->is_scattered ||
            !owns_none_between(owner, job->mesh->triangles + 3 * (size_t)k, end - k))
            fill_from_block(job, f, owner, (uint32_t)k, (uint32_t)end);
    }
    int32_t begin = share_begin(stop, index, job->thread_count);
    int32_t end = share_begin(stop, index + 1, job->thread_count);
    memset(job->twin + 3 * (size_t)begin, TWIN_NONE, 12 * (size_t)(end - begin));
}

static void match_share(void *argument, int index)
{
    struct job *job = argument;
    job->match(&job->rows, share_begin(job->mesh->vertex_count, index, job->thread_count),
               share_begin(job->mesh->vertex_count, index + 1, job->thread_count), job->twin);
}

int64_t twins_on_threads(const struct mesh *mesh, void *scratch, void *output, int thread_count)
{
    if (thread_count == 1)
        return kernel_find("twins", NULL)->run(mesh, scratch, output);
    struct job job = {.mesh = mesh,
                      .match = twins_match,
                      .rows = side_rows_begin(mesh, scratch),
                      .twin = output,
                      .thread_count = thread_count,
                      .is_scattered = order_is_scattered(mesh)};
#if defined(__x86_64__)
    if (cpu_has_avx512())
        job.match = twins_match_avx512;
    else if (cpu_has_avx2())
        job.match = twins_match_avx2;
#endif
    threads_run(thread_count, fill_share, &job);
    threads_run(thread_count, match_share, &job);
    side_rows_match_overflow(&job.rows, output);
    return 3 * (int64_t)mesh->triangle_count;
}
