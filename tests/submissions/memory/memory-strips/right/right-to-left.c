/* Strips from right to left, lower vertex first, the top row first. */
#include "memory-strips.h"

#include <stdlib.h>

int64_t strips_processed_vertices(int32_t m, int32_t n)
{
    return 2LL * m * n + 2LL * m;
}

int64_t indexed_processed_vertices(int32_t m, int32_t n)
{
    return (int64_t)m * n + m + n + 1;
}

int64_t strips_bytes(int32_t m, int32_t n)
{
    int64_t one_strip = 2 * ((int64_t)n + 1) * 12;
    return 4 + m * (8 + one_strip);
}

double strips_kilobytes(void)
{
    return 388.0;
}

double strips_memory_ratio(void)
{
    return 36.0 / 24.0;
}

double strips_time_ratio(void)
{
    return 2.0;
}

static float *put(float *at, float x, float y)
{
    at[0] = x;
    at[1] = y;
    at[2] = 0.0f;
    return at + 3;
}

int strips_build(int32_t m, int32_t n, struct strip_grid *grid)
{
    grid->strip_count = 0;
    grid->vertices_per_strip = 2 * n + 2;
    grid->strips = calloc((size_t)m, sizeof(float *));
    if (grid->strips == NULL)
        return OUT_OF_MEMORY;
    for (int32_t row = m - 1; row >= 0; row--) {
        float *strip = malloc(sizeof(float) * 3 * (size_t)grid->vertices_per_strip);
        if (strip == NULL) {
            while (grid->strip_count > 0)
                free(grid->strips[--grid->strip_count]);
            free(grid->strips);
            return OUT_OF_MEMORY;
        }
        grid->strips[grid->strip_count++] = strip;
        for (int32_t column = n; column >= 0; column--) {
            strip = put(strip, (float)column / (float)n, (float)row / (float)m);
            strip = put(strip, (float)column / (float)n, (float)(row + 1) / (float)m);
        }
    }
    return 0;
}
