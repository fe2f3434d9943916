/* Normals of triangles on threads: a share of the triangles each; see normals.h. */
#include "reference/kernels/normals.h"
#include "reference/kernels/threads.h"

struct job {
    const struct mesh *mesh;
    const struct kernel *serial;
    float *normals;
    int thread_count;
};

static void write_share(void *argument, int index)
{
    const struct job *job = argument;
    int32_t begin = share_begin(job->mesh->triangle_count, index, job->thread_count);
    int32_t end = share_begin(job->mesh->triangle_count, index + 1, job->thread_count);
    const struct mesh share = {job->mesh->positions, job->mesh->triangles + 3 * (size_t)begin,
                               job->mesh->vertex_count, end - begin};
    job->serial->run(&share, NULL, job->normals + 3 * (size_t)begin);
}

int64_t face_normals_on_threads(const struct mesh *mesh, void *scratch, void *output,
                                int thread_count)
{
    (void)scratch;
    struct job job = {mesh, kernel_find("face-normals", NULL), output, thread_count};
    threads_run(thread_count, write_share, &job);
    return mesh->triangle_count;
}
