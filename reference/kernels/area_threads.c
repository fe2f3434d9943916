/* Area on threads: a share of the triangles each; see area.h. */
#include "reference/kernels/area.h"
#include "reference/kernels/threads.h"

struct job {
    const struct mesh *mesh;
    const struct kernel *serial;
    double *areas; /* one a cache line */
    int thread_count;
};

enum { DOUBLES_A_LINE = 8 };

size_t area_threads_scratch_bytes(int64_t vertex_count, int64_t triangle_count)
{
    (void)vertex_count;
    (void)triangle_count;
    return (size_t)KERNEL_MOST_THREADS * DOUBLES_A_LINE * sizeof(double);
}

static void add_share(void *argument, int index)
{
    const struct job *job = argument;
    int32_t begin = share_begin(job->mesh->triangle_count, index, job->thread_count);
    int32_t end = share_begin(job->mesh->triangle_count, index + 1, job->thread_count);
    const struct mesh share = {job->mesh->positions, job->mesh->triangles + 3 * (size_t)begin,
                               job->mesh->vertex_count, end - begin};
    job->serial->run(&share, NULL, job->areas + DOUBLES_A_LINE * index);
}

int64_t area_on_threads(const struct mesh *mesh, void *scratch, void *output, int thread_count)
{
    struct job job = {mesh, kernel_find("area", NULL), scratch, thread_count};
    threads_run(thread_count, add_share, &job);
    double area = 0;
    for (int k = 0; k < thread_count; k++)
        area += job.areas[DOUBLES_A_LINE * k];
    *(double *)output = area;
    return 1;
}
