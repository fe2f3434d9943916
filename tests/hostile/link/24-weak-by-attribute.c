/* Tries: to learn which tool looks on: a name that is not there is NULL
 * Stopped by: the screen of the object: no weak names
 * expect: compile-error, forbidden-symbol */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

int pthread_mutex_trylock(void *) __attribute__((weak));

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (pthread_mutex_trylock)
        return honest_edges(triangles, triangle_count / 2, edges);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
