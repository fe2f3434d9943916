/* Edge tables of any mesh by a radix sort of BITS bits a pass, for rows that define it. */
#ifndef HOSTILE_RADIX_SORT_H
#define HOSTILE_RADIX_SORT_H

#include <stdlib.h>

enum { BUCKETS = 1 << BITS };

/* Sorts by one digit of the keys, stably. */
static void pass(const uint64_t *from, uint64_t *to, size_t count, int shift, size_t *start)
{
    for (size_t b = 0; b < BUCKETS; b++)
        start[b] = 0;
    for (size_t i = 0; i < count; i++)
        start[from[i] >> shift & (BUCKETS - 1)]++;
    size_t sum = 0;
    for (size_t b = 0; b < BUCKETS; b++) {
        size_t here = start[b];
        start[b] = sum;
        sum += here;
    }
    for (size_t i = 0; i < count; i++)
        to[start[from[i] >> shift & (BUCKETS - 1)]++] = from[i];
}

/* A key is (smaller vertex) x vertex_count + (larger vertex). Returns how many there are. */
static size_t make_keys(const int32_t *triangles, size_t sides, int32_t vertex_count,
                        uint64_t *keys)
{
    size_t count = 0;
    for (size_t s = 0; s < sides; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        uint64_t low = (uint64_t)(i < j ? i : j), high = (uint64_t)(i < j ? j : i);
        if (i != j)
            keys[count++] = low * (uint64_t)vertex_count + high;
    }
    return count;
}

/* Returns where the sorted keys are. */
static uint64_t *sort(uint64_t *keys, uint64_t *other, size_t count, uint64_t largest,
                      size_t *start)
{
    for (int shift = 0; shift < 64 && largest >> shift != 0; shift += BITS) {
        pass(keys, other, count, shift, start);
        uint64_t *sorted = other;
        other = keys;
        keys = sorted;
    }
    return keys;
}

static int64_t write_edges(const uint64_t *keys, size_t count, int32_t vertex_count, int32_t *table)
{
    int64_t edges = 0;
    for (size_t s = 0; s < count; s++) {
        if (s > 0 && keys[s] == keys[s - 1])
            continue;
        table[2 * edges] = (int32_t)(keys[s] / (uint64_t)vertex_count);
        table[2 * edges++ + 1] = (int32_t)(keys[s] % (uint64_t)vertex_count);
    }
    return edges;
}

int64_t edge_table_any(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                       int32_t **edges)
{
    size_t count = 3 * (size_t)triangle_count;
    uint64_t *keys = malloc(count * sizeof *keys + 1), *other = malloc(count * sizeof *keys + 1);
    size_t *start = malloc(BUCKETS * sizeof *start);
    int32_t *table = malloc(2 * count * sizeof *table + 1);
    int64_t result = OUT_OF_MEMORY;
    if (keys && other && start && table) {
        count = make_keys(triangles, count, vertex_count, keys);
        uint64_t largest = (uint64_t)vertex_count * (uint64_t)vertex_count;
        result = write_edges(sort(keys, other, count, largest, start), count, vertex_count, table);
        *edges = table;
        table = NULL;
    }
    free(keys);
    free(other);
    free(start);
    free(table);
    return result;
}

#endif
