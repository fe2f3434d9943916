/* A hash table with open addressing that remembers the edges met so far. */
#include "edge-table-closed.h"

#include <stdlib.h>

static uint64_t hash(uint64_t key)
{
    key *= 0x9E3779B97F4A7C15u;
    return key ^ key >> 32;
}

/* Whether the key is new to the table, which has a power of two of slots; 0 is a free slot. */
static int insert(uint64_t *slots, size_t mask, uint64_t key)
{
    size_t i = hash(key) & mask;
    while (slots[i] != 0 && slots[i] != key)
        i = (i + 1) & mask;
    if (slots[i] == key)
        return 0;
    slots[i] = key;
    return 1;
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    (void)vertex_count;
    size_t slot_count = 16;
    while (slot_count < 6 * (size_t)triangle_count)
        slot_count *= 2;
    uint64_t *slots = calloc(slot_count, sizeof *slots);
    int32_t *table = malloc(6 * (size_t)triangle_count * sizeof *table + 1);
    if (!slots || !table) {
        free(slots);
        free(table);
        return OUT_OF_MEMORY;
    }
    int64_t count = 0;
    for (int32_t t = 0; t < triangle_count; t++)
        for (int k = 0; k < 3; k++) {
            int32_t i = triangles[3 * (size_t)t + (size_t)k];
            int32_t j = triangles[3 * (size_t)t + (size_t)(k + 1) % 3];
            uint64_t low = (uint64_t)(i < j ? i : j), high = (uint64_t)(i < j ? j : i);
            /* high is at least 1, so the key is never 0. */
            if (i != j && insert(slots, slot_count - 1, low << 32 | high)) {
                table[2 * count] = i;
                table[2 * count + 1] = j;
                count++;
            }
        }
    free(slots);
    *edges = table;
    return count;
}
