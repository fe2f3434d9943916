/* Tries: to run a program
 * Stopped by: the screen of the object: undefined names
 * expect: compile-error, forbidden-symbol */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <spawn.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    char *nothing[] = {NULL};
    posix_spawn(&(pid_t){0}, "/bin/id", NULL, NULL, nothing, nothing);
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
