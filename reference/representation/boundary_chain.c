/* Chaining boundary sides; see boundary_chain.h.
 *
 * Each vertex has a list of the ends of sides that lie there, outgoing ones in front. End 2 * s is
 * where side s starts, end 2 * s + 1 where it stops. */
#include "reference/representation/boundary_chain.h"

#include <stdlib.h>
#include <string.h>

struct chain {
    const int32_t *sides;
    int32_t *head;    /* of each vertex: its first end, or -1 */
    int32_t *link;    /* of each end: the next one at the same vertex, or -1 */
    uint8_t *is_used; /* of each side */
};

static void chain_release(struct chain *chain)
{
    free(chain->head);
    free(chain->link);
    free(chain->is_used);
}

static int chain_init(struct chain *chain, const int32_t *sides, int64_t side_count,
                      int32_t vertex_count, struct error *err)
{
    chain->sides = sides;
    chain->head = malloc((size_t)vertex_count * sizeof *chain->head + 1);
    chain->link = malloc(2 * (size_t)side_count * sizeof *chain->link + 1);
    chain->is_used = calloc((size_t)side_count + 1, 1);
    if (!chain->head || !chain->link || !chain->is_used) {
        chain_release(chain);
        error_set(err, "out of memory: chaining %lld boundary edges", (long long)side_count);
        return -1;
    }
    memset(chain->head, 0xff, (size_t)vertex_count * sizeof *chain->head);
    for (int end = 1; end >= 0; end--) /* incoming first: what is put in later stands in front */
        for (int64_t i = 2 * side_count - 2 + end; i >= 0; i -= 2) {
            chain->link[i] = chain->head[sides[i]];
            chain->head[sides[i]] = (int32_t)i;
        }
    return 0;
}

/* Takes an unused side at vertex v and returns its other end; -1 when there is none. */
static int32_t follow_side(struct chain *chain, int32_t v)
{
    while (chain->head[v] >= 0) {
        int32_t end = chain->head[v];
        chain->head[v] = chain->link[end];
        if (!chain->is_used[end / 2]) {
            chain->is_used[end / 2] = 1;
            return chain->sides[end ^ 1];
        }
    }
    return -1;
}

int32_t boundary_chain(const int32_t *sides, int64_t side_count, int32_t vertex_count,
                       int32_t *vertices, int32_t *loop_starts, struct error *err)
{
    struct chain chain;
    if (chain_init(&chain, sides, side_count, vertex_count, err))
        return -1;
    int32_t loop_count = 0, written = 0;
    for (int64_t side = 0; side < side_count && loop_count >= 0; side++) {
        if (chain.is_used[side])
            continue;
        int32_t start = sides[2 * side], v = start;
        loop_starts[loop_count++] = written;
        do {
            vertices[written++] = v;
            int32_t next = follow_side(&chain, v);
            if (next < 0)
                loop_count = error_set(err, "vertex %d: the boundary does not go on there", v);
            v = next;
        } while (v >= 0 && v != start);
    }
    if (loop_count >= 0)
        loop_starts[loop_count] = written;
    chain_release(&chain);
    return loop_count;
}
