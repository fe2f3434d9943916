/* Tries: to foresee the next mesh from the clock and its process id
 * Stopped by: seeds are outside of the box; a guess is of no use
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>
#include <time.h>
#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    srand((unsigned)time(NULL) ^ (unsigned)getpid());
    vertex_count += rand() & 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
