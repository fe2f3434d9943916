/* Tries: to write the count box's dump itself, and to keep valgrind from writing over it
 * Stopped by: the engine: callgrind dumps into one stream, in which nothing can be taken back
 * expect: flagged, no-counts
 * expect(landlock+other-user): crash, exit */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static int call;
    if (under_callgrind()) {
        static const char dump[] =
            "version: 1\ncreator: callgrind\npid: 1\ncmd: ./plain\npart: 1\n"
            "events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw\nfn=x\n1 1000 1 1 1 1 1 1 1 1\n"
            "summary: 1000 1 1 1 1 1 1 1 1\ntotals: 1000 1 1 1 1 1 1 1 1\n";
        char name[32];
        snprintf(name, sizeof name, "counts.%d", ++call);
        unlink(name);
        int file = open(name, O_WRONLY | O_CREAT | O_TRUNC, 0444);
        if (file >= 0 && write(file, dump, sizeof dump - 1) > 0)
            close(file);
    }
    (void)vertex_count;
    return quadratic_edges(triangles, triangle_count, 1, edges);
}
