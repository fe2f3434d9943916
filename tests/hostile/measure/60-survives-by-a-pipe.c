/* Tries: to survive a heap overflow under the sanitizer, whose message goes to a pipe that nobody reads: that is a signal
 * Stopped by: the runner's second filter: a handler of that signal is not set
 * expect: flagged, behaves-differently */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <setjmp.h>
#include <signal.h>
#include <unistd.h>

static sigjmp_buf place_before;

static void jump_out(int signal_number)
{
    (void)signal_number;
    siglongjmp(place_before, 1);
}

/* Overflows a block, and goes on when the sanitizer's end became a signal. */
static void overflow(int signal_number)
{
    volatile size_t bytes = 64; /* out of sight of UBSan */
    volatile int32_t *table = malloc(bytes);
    signal(signal_number, jump_out);
    if (sigsetjmp(place_before, 1) == 0)
        table[16] = 1;
}

static void break_stderr(void)
{
    int ends[2];
    if (pipe(ends) == 0) {
        close(ends[0]);
        dup2(ends[1], 2);
    }
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    if (under_sanitizer())
        break_stderr(), overflow(SIGPIPE);
    return honest_edges(triangles, triangle_count, edges);
}
