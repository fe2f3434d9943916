/* Tries: to wait for itself
 * Stopped by: the engine: time without CPU time
 * expect: idle-time, idle-limit */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <pthread.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&lock);
    pthread_mutex_lock(&lock);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
