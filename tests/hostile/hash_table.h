/* Edge tables of any mesh by a hash table that doubles when it is LOAD_PERCENT full, for rows that
 * define it. */
#ifndef HOSTILE_HASH_TABLE_H
#define HOSTILE_HASH_TABLE_H

#include <stdbool.h>
#include <stdlib.h>

enum { FIRST_SLOTS = 16 };

struct table {
    uint64_t *keys; /* 0: empty */
    size_t slots, count;
};

static size_t slot_of(const struct table *table, uint64_t key)
{
    uint64_t mixed = key * 0x9E3779B97F4A7C15u;
    size_t slot = (size_t)(mixed ^ mixed >> 32) & (table->slots - 1);
    while (table->keys[slot] && table->keys[slot] != key)
        slot = (slot + 1) & (table->slots - 1);
    return slot;
}

static bool grow(struct table *table)
{
    struct table larger = {NULL, table->slots ? 2 * table->slots : FIRST_SLOTS, table->count};
    larger.keys = calloc(larger.slots, sizeof *larger.keys);
    if (!larger.keys)
        return false;
    for (size_t i = 0; i < table->slots; i++)
        if (table->keys[i])
            larger.keys[slot_of(&larger, table->keys[i])] = table->keys[i];
    free(table->keys);
    *table = larger;
    return true;
}

static bool insert(struct table *table, uint64_t key)
{
    if (100 * (table->count + 1) > LOAD_PERCENT * table->slots && !grow(table))
        return false;
    size_t slot = slot_of(table, key);
    if (!table->keys[slot]) {
        table->keys[slot] = key;
        table->count++;
    }
    return true;
}

/* The smaller vertex above, the larger below, which is never 0. */
static uint64_t key_of(int32_t i, int32_t j)
{
    return i < j ? (uint64_t)i << 32 | (uint64_t)j : (uint64_t)j << 32 | (uint64_t)i;
}

static int64_t write_edges(const struct table *table, int32_t **edges)
{
    int32_t *made = malloc(2 * table->count * sizeof *made + 1);
    int64_t count = 0;
    if (!made)
        return OUT_OF_MEMORY;
    for (size_t i = 0; i < table->slots; i++)
        if (table->keys[i]) {
            made[2 * count] = (int32_t)(table->keys[i] >> 32);
            made[2 * count++ + 1] = (int32_t)(table->keys[i] & 0xffffffffu);
        }
    *edges = made;
    return count;
}

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    struct table table = {NULL, 0, 0};
    bool fits = true;
    (void)vertex_count;
    for (size_t s = 0; s < 3 * (size_t)triangle_count && fits; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        fits = i == j || insert(&table, key_of(i, j));
    }
    int64_t result = fits ? write_edges(&table, edges) : OUT_OF_MEMORY;
    free(table.keys);
    return result;
}

#endif
