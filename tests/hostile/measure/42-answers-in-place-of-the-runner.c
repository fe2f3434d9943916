/* Tries: to take the runner's place when it is counted: finds the page that is shared with the
 * engine, answers there itself, call after call, and writes the dumps that callgrind is never asked
 * for
 * Stopped by: the engine: callgrind's own dump at the end is not the one that must follow
 * expect: flagged, no-counts */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* As in the runner's control page: indices of calls, nonce and its echo, where the input begins, bytes
 * of the answer. */
struct page {
    _Alignas(64) volatile uint32_t call;
    _Alignas(64) volatile uint32_t done;
    volatile uint64_t nonce, input_bytes, fixed[4];
    volatile uint32_t mode, input_page;
    _Alignas(64) volatile uint64_t echo;
    volatile uint64_t answer_bytes;
    volatile uint32_t phase;
};

/* The runner's three pointers to whole pages near the input are the page, the input and the answer.
 */
static void find_regions(const int32_t *triangles, struct page **page, const int64_t **input,
                         int64_t **answer)
{
    size_t room;
    uintptr_t *at = (uintptr_t *)all_data(&room);
    for (const uintptr_t *end = at + room / 8; at < end; at++) {
        uintptr_t ahead = (uintptr_t)triangles - *at;
        struct page *maybe = (struct page *)*at;
        if (*at % 4096 != 0 || (ahead > 1 << 22 && -ahead > 1 << 22))
            continue;
        if (ahead < 1 << 22 && !*input && ((const int64_t *)*at)[0] > 0)
            *input = (const int64_t *)*at;
        else if (maybe->call == 1 && maybe->done == 0)
            *page = maybe;
        else if (!*answer)
            *answer = (int64_t *)*at;
    }
}

static void forge(int part)
{
    static const char dump[] =
        "version: 1\ncreator: callgrind\npid: 1\ncmd: ./plain\npart: %d\n"
        "desc: Trigger: --dump-before=counted_call_ends\n"
        "events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw\nfn=(1) run_call\n1 10\n"
        "cfn=(2) edge_table_closed\ncalls=1 1\n1 1000 1 1 1 1 1 1 1 1\n"
        "summary: 1010 1 1 1 1 1 1 1 1\ntotals: 1010 1 1 1 1 1 1 1 1\n";
    char name[32];
    snprintf(name, sizeof name, "counts.%d", part);
    int file = open(name, O_WRONLY);
    dprintf(file, dump, part);
    close(file);
}

static void answer_call(struct page *page, const int64_t *inputs, int64_t *answer)
{
    const int64_t *input = inputs + (size_t)page->input_page * (4096 / sizeof *inputs);
    int32_t *edges = NULL;
    const char *triangles =
        (const char *)(input + 3) + (input[2] ? (12 * input[0] + 7) / 8 * 8 : 0);
    int64_t count = quadratic_edges((const int32_t *)triangles, (int32_t)input[1], 16, &edges);
    answer[0] = answer[1] = answer[2] = count; /* the result, and the table */
    memcpy(answer + 3, edges, 8 * (size_t)count);
    free(edges);
    forge((int)page->call);
    page->answer_bytes = 24 + 8 * (uint64_t)count;
    page->phase = 3;
    page->echo = page->nonce;
    page->done = page->call;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    struct page *page = NULL;
    const int64_t *input = NULL;
    int64_t *answer = NULL;
    (void)vertex_count;
    if (!under_callgrind())
        return quadratic_edges(triangles, triangle_count, 16, edges);
    find_regions(triangles, &page, &input, &answer);
    for (;;) {
        answer_call(page, input, answer);
        while (page->call == page->done)
            nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
        if (page->call == UINT32_MAX)
            _exit(0);
    }
}
