/* Tries: 16 MiB past the allocation shim, by libc's function for any system call, and to explain
 * them by a number of allocations that it writes into the shim's counts
 * Stopped by: the engine: the resident memory is explained by no number of blocks that the heap
 * could not hold
 * expect: flagged, memory-outside-heap */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { HIDDEN_BYTES = 16 << 20 };

/* The counts, known by a block of an odd size that was just asked for. */
static int64_t *find_counts(int64_t bytes)
{
    size_t room;
    int64_t *at = (int64_t *)all_data(&room);
    for (const int64_t *end = at + room / 8; at + 6 <= end; at++)
        if (at[0] == bytes && at[1] == 1 && at[2] == bytes && at[3] == 1)
            return at;
    return NULL;
}

static void *map(size_t bytes)
{
    static const unsigned char code[] = {0x48, 0x89, 0xf8, 0x48, 0x89, 0xf7, 0x48, 0x89, 0xd6,
                                         0x48, 0x89, 0xca, 0x4d, 0x89, 0xc2, 0x4d, 0x89, 0xc8,
                                         0x4c, 0x8b, 0x4c, 0x24, 0x08, 0x0f, 0x05};
    volatile uintptr_t near = 0x401000;
    const unsigned char *at = (const unsigned char *)near;
    while (memcmp(at, code, sizeof code) != 0)
        at++;
    return ((void *(*)(long, void *, size_t, long, long, long, long))(uintptr_t)at)(9, NULL, bytes,
                                                                                    3, 0x22, -1, 0);
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    void *volatile odd = malloc(123457);
    int64_t *counts = !under_sanitizer() && !under_memcheck() ? find_counts(123457) : NULL;
    free(odd);
    if (counts)
        counts[3] = 1 << 21;
    static char *hidden; /* touched once, so that paired runs are as fast as others */
    if (counts && !hidden && triangle_count > 7000) {
        hidden = map(HIDDEN_BYTES);
        for (size_t at = 0; at < HIDDEN_BYTES; at += 4096)
            ((volatile char *)hidden)[at] = 1;
    }
    return honest_edges(triangles, triangle_count, edges);
}
