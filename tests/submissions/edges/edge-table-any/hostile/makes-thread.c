/* Lets a thread work on.
 * expect: compile-error */
#include "edge-table-any.h"

#include <pthread.h>
#include <stddef.h>

static void *work(void *nothing)
{
    for (volatile int goes_on = 1; goes_on;)
        ;
    return nothing;
}

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    (void)triangles;
    (void)triangle_count;
    (void)vertex_count;
    *edges = NULL;
    pthread_t thread;
    return pthread_create(&thread, NULL, work, NULL);
}
