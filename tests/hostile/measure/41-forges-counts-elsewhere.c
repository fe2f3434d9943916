/* Tries: to write the count box's dumps itself, while callgrind writes its own into another folder,
 * to which the program went
 * Stopped by: the runner gives up going to other folders before the first call
 * expect: forbidden-operation, ? */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

static void forge(int part)
{
    static const char dump[] =
        "version: 1\ncreator: callgrind\npid: 1\ncmd: ./plain\npart: %d\n"
        "desc: Trigger: --dump-before=counted_call_ends\n"
        "events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw\nfn=(1) run_call\n1 10\n"
        "cfn=(2) edge_table_closed\ncalls=1 1\n1 1000 1 1 1 1 1 1 1 1\n"
        "summary: 1010 1 1 1 1 1 1 1 1\ntotals: 1010 1 1 1 1 1 1 1 1\n";
    char name[32];
    snprintf(name, sizeof name, part > 1 ? "../counts.%d" : "counts.%d", part);
    int file = open(name, O_WRONLY);
    dprintf(file, dump, part);
    close(file);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    static int call;
    if (under_callgrind()) {
        forge(++call);
        if (call == 1 && chdir("tmp"))
            abort();
    }
    (void)vertex_count;
    return quadratic_edges(triangles, triangle_count, 16, edges);
}
