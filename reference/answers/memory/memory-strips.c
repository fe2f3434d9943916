/* Problem 4.3: the grid as strips, each from left to right, upper vertex first. */
#include "memory-strips.h"

#include <stdlib.h>

int64_t strips_bytes(int32_t m, int32_t n)
{
    int64_t table_bytes = (int64_t)sizeof(int32_t) + (int64_t)m * (int64_t)sizeof(float *);
    return table_bytes + strips_processed_vertices(m, n) * 3 * (int64_t)sizeof(float);
}

double strips_kilobytes(void)
{
    return (double)strips_bytes(128, 128) / 1024;
}

int64_t strips_processed_vertices(int32_t m, int32_t n)
{
    return (int64_t)m * 2 * ((int64_t)n + 1);
}

int64_t indexed_processed_vertices(int32_t m, int32_t n)
{
    return ((int64_t)m + 1) * ((int64_t)n + 1);
}

double strips_memory_ratio(void)
{
    return 1.5; /* 36 mn / 24 mn */
}

double strips_time_ratio(void)
{
    return 2; /* 2m(n + 1) / ((m + 1)(n + 1)) */
}

static void free_strips(float **strips, int32_t count)
{
    for (int32_t row = 0; row < count; row++)
        free(strips[row]);
    free(strips);
}

static void place_strip(int32_t m, int32_t n, int32_t row, float *strip)
{
    float low = (float)row / (float)m;
    float high = (float)(row + 1) / (float)m;
    float *at = strip;
    for (int32_t column = 0; column <= n; column++) {
        float x = (float)column / (float)n;
        *at++ = x;
        *at++ = high;
        *at++ = 0;
        *at++ = x;
        *at++ = low;
        *at++ = 0;
    }
}

int strips_build(int32_t m, int32_t n, struct strip_grid *grid)
{
    size_t vertices_per_strip = 2 * ((size_t)n + 1);
    float **strips = malloc((size_t)m * sizeof *strips);
    if (!strips)
        return OUT_OF_MEMORY;
    for (int32_t row = 0; row < m; row++) {
        strips[row] = malloc(vertices_per_strip * 3 * sizeof *strips[row]);
        if (!strips[row]) {
            free_strips(strips, row);
            return OUT_OF_MEMORY;
        }
        place_strip(m, n, row, strips[row]);
    }
    grid->strips = strips;
    grid->strip_count = m;
    grid->vertices_per_strip = (int32_t)vertices_per_strip;
    return 0;
}
