/* Makes one number i * V + j of an edge, in 32 bits: from 65536 vertices on, edges share numbers.
 * fails: high-numbers */
#include "edge-table-closed.h"

#include <stdlib.h>

/* Sorts by bytes, the lowest first; `other` has as much room. */
static void sort_keys(uint32_t *keys, uint32_t *other, size_t count)
{
    for (int shift = 0; shift < 32; shift += 8) {
        size_t start[257] = {0};
        for (size_t k = 0; k < count; k++)
            start[(keys[k] >> shift & 255) + 1]++;
        for (int byte = 0; byte < 256; byte++)
            start[byte + 1] += start[byte];
        for (size_t k = 0; k < count; k++)
            other[start[keys[k] >> shift & 255]++] = keys[k];
        uint32_t *sorted = other;
        other = keys;
        keys = sorted;
    }
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    uint32_t *keys = malloc(6 * (size_t)triangle_count * sizeof *keys + 1);
    int32_t *table = calloc(6 * (size_t)triangle_count + 2, sizeof *table);
    if (!keys || !table) {
        free(keys);
        free(table);
        return OUT_OF_MEMORY;
    }
    uint32_t n = (uint32_t)vertex_count;
    size_t side_count = 0;
    for (size_t s = 0; s < 3 * (size_t)triangle_count; s++) {
        int32_t i = triangles[s], j = triangles[s % 3 == 2 ? s - 2 : s + 1];
        if (i != j)
            keys[side_count++] = (uint32_t)(i < j ? i : j) * n + (uint32_t)(i < j ? j : i);
    }
    sort_keys(keys, keys + side_count, side_count);
    int64_t count = 0;
    for (size_t s = 0; s < side_count; s++)
        if (s == 0 || keys[s] != keys[s - 1]) {
            table[2 * count] = (int32_t)(keys[s] / n);
            table[2 * count++ + 1] = (int32_t)(keys[s] % n);
        }
    free(keys);
    *edges = table;
    return count;
}
