/* A hash table of directed sides (i,j), by open addressing. A side whose reverse is not in it is on
 * the boundary; such sides are chained at the vertex where they begin. */
#include "boundary-loops.h"

#include <stdlib.h>

/* Keys are one more than begin * 2^32 + end: 0 is a free slot. */
struct table {
    uint64_t *slots;
    size_t mask;
};

static uint64_t key_of(int32_t begin, int32_t end)
{
    return ((uint64_t)begin << 32 | (uint32_t)end) + 1;
}

/* The slot that has the key, or where it belongs. */
static uint64_t *find(const struct table *table, uint64_t key)
{
    uint64_t hash = key * 0x9E3779B97F4A7C15u;
    size_t i = (hash ^ hash >> 32) & table->mask;
    while (table->slots[i] != 0 && table->slots[i] != key)
        i = (i + 1) & table->mask;
    return &table->slots[i];
}

static void chain_boundary(const struct table *table, const int32_t *triangles, int32_t side_count,
                           int32_t *head, int32_t *next)
{
    for (int32_t s = 0; s < side_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        if (*find(table, key_of(j, i)) != 0)
            continue;
        next[s] = head[i];
        head[i] = s;
    }
}

static int32_t collect(const int32_t *triangles, int32_t vertex_count, int32_t *head,
                       const int32_t *next, int32_t *first, int32_t *vertices)
{
    int32_t loops = 0, length = 0;
    first[0] = 0;
    for (int32_t start = 0; start < vertex_count; start++)
        while (head[start] >= 0) {
            int32_t v = start;
            do {
                int32_t s = head[v];
                head[v] = next[s];
                vertices[length++] = v;
                v = triangles[s % 3 == 2 ? s - 2 : s + 1];
            } while (v != start);
            first[++loops] = length;
        }
    return loops;
}

int32_t boundary_loops(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **first, int32_t **vertices)
{
    int32_t side_count = 3 * triangle_count, loops = OUT_OF_MEMORY;
    size_t slot_count = 16;
    while (slot_count < 4 * (size_t)triangle_count)
        slot_count *= 2;
    struct table table = {calloc(slot_count, sizeof *table.slots), slot_count - 1};
    int32_t *head = malloc((size_t)vertex_count * sizeof *head + 1);
    int32_t *next = malloc((size_t)side_count * sizeof *next + 1);
    *first = malloc(((size_t)triangle_count + 1) * sizeof **first);
    *vertices = malloc((size_t)side_count * sizeof **vertices + 1);
    if (table.slots && head && next && *first && *vertices) {
        for (int32_t v = 0; v < vertex_count; v++)
            head[v] = -1;
        for (int32_t s = 0; s < side_count; s++) {
            uint64_t key = key_of(triangles[s], triangles[s % 3 == 2 ? s - 2 : s + 1]);
            *find(&table, key) = key;
        }
        chain_boundary(&table, triangles, side_count, head, next);
        loops = collect(triangles, vertex_count, head, next, *first, *vertices);
    } else {
        free(*first);
        free(*vertices);
    }
    free(table.slots);
    free(head);
    free(next);
    return loops;
}
