/* Tries: links to a file of the host where the dumps should be
 * Stopped by: the dumps are there before the submission, which can make nothing; and the engine
 * follows no links
 * expect: passed
 * expect(landlock+other-user): crash, exit */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static int call;
    if (under_callgrind()) {
        char name[32];
        snprintf(name, sizeof name, "counts.%d", ++call);
        unlink(name);
        (void)!symlink("/etc/passwd", name);
    }
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
