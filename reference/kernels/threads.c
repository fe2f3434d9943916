/* Work split over threads; see threads.h. */
#include "reference/kernels/threads.h"

#include "reference/kernels/kernel.h"

#include <pthread.h>

struct task {
    void (*work)(void *job, int index);
    void *job;
    int index;
};

static void *run_task(void *argument)
{
    const struct task *task = argument;
    task->work(task->job, task->index);
    return NULL;
}

void threads_run(int thread_count, void (*work)(void *job, int index), void *job)
{
    struct task tasks[KERNEL_MOST_THREADS];
    pthread_t threads[KERNEL_MOST_THREADS];
    int started = 0;
    for (; started < thread_count - 1; started++) {
        tasks[started] = (struct task){work, job, started};
        if (pthread_create(&threads[started], NULL, run_task, &tasks[started]) != 0)
            break;
    }
    for (int k = started; k < thread_count; k++)
        work(job, k);
    for (int k = 0; k < started; k++)
        pthread_join(threads[k], NULL);
}

int threads_worth(int32_t triangle_count)
{
    enum { TRIANGLES_A_THREAD = 50000 };
    int worth = triangle_count / TRIANGLES_A_THREAD + 1, most = kernel_thread_count();
    return worth < most ? worth : most;
}
