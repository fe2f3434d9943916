/* Tries: a table made in the first call and kept for the next, for speed
 * Stopped by: nothing: it must pass
 * expect: passed */
#define _GNU_SOURCE
#include "edge-table-closed.h"
#include "honest.h"

#include <stdbool.h>

/* How many bits a number has, by a table that is filled once. */
static int bits_of(uint32_t number)
{
    static unsigned char bits[1 << 12];
    static bool is_filled;
    if (!is_filled)
        for (uint32_t i = 1; i < sizeof bits; i++)
            bits[i] = (unsigned char)(bits[i / 2] + 1);
    is_filled = true;
    return number >= sizeof bits ? 12 + bits_of(number >> 12) : bits[number];
}

int64_t edge_table_closed(const int32_t *triangles, int32_t triangle_count, int32_t vertex_count,
                          int32_t **edges)
{
    if (triangle_count < 0 || (uint32_t)bits_of((uint32_t)triangle_count) > 31)
        return 0;
    (void)vertex_count;
    return honest_edges(triangles, triangle_count, edges);
}
