/* Tries: to return at once and fill the table from a timer, after the measurement
 * Stopped by: the seccomp filter of the run box, and of the tools'
 * expect: forbidden-operation, setitimer */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <signal.h>
#include <string.h>
#include <sys/time.h>

static const int32_t *later_triangles;
static int32_t later_count, *later_table;

static void work_later(int number)
{
    int32_t *table;
    (void)number;
    int64_t count = honest_edges(later_triangles, later_count, &table);
    if (count > 0) {
        memcpy(later_table, table, 2 * (size_t)count * sizeof *table);
        free(table);
    }
}

/* A closed mesh has 3/2 edges a triangle, so that the count costs nothing. */
int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    struct itimerval soon = {{0, 0}, {0, 1}};
    (void)vertex_count;
    later_triangles = triangles;
    later_count = triangle_count;
    *edges = later_table = malloc(3 * (size_t)triangle_count * sizeof *later_table + 1);
    if (!later_table)
        return OUT_OF_MEMORY;
    signal(SIGALRM, work_later);
    setitimer(ITIMER_REAL, &soon, NULL);
    return 3 * (int64_t)triangle_count / 2;
}
