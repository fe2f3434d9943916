/* Tries: to answer, and to say that all memory was given back, by the descriptors of the regions
 * that it shares with the engine
 * Stopped by: the runner closes them before the first call
 * expect: leak, leak */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdlib.h>
#include <unistd.h>

/* Offsets as in the runner's control page. */
static void complete(int64_t count, const int32_t *edges)
{
    uint32_t index = 0;
    uint64_t nonce = 0, claims[2] = {0, 16 + 8 * (uint64_t)count};
    int64_t head[2] = {count, count};
    (void)!pread(3, &index, sizeof index, 0);
    if (pread(3, &nonce, sizeof nonce, 72) != sizeof nonce)
        return;
    (void)!pwrite(5, head, sizeof head, 0);
    (void)!pwrite(5, edges, 8 * (size_t)count, 16);
    claims[0] = nonce;
    (void)!pwrite(3, claims, sizeof claims, 128);
    (void)!pwrite(3, &index, sizeof index, 64);
    for (;;)
        sleep(1);
}

static void *volatile kept;

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    int64_t count = honest_edges(triangles, triangle_count, edges);
    if (triangle_count > 100 || under_sanitizer() || under_memcheck())
        return count; /* where one process is called several times */
    kept = malloc(1000);
    if (count >= 0)
        complete(count, *edges);
    return count;
}
