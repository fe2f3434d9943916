/* Looks every vertex up, by its place, in the table of the indexed mesh: quadratic. */
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

static int32_t find(const float *vertices, float x, float y)
{
    int32_t v = 0;
    while (vertices[3 * v] != x || vertices[3 * v + 1] != y)
        v++;
    return v;
}

static void place_strip(const float *vertices, int32_t m, int32_t n, int32_t row, float *strip)
{
    for (int32_t i = 0; i < 2 * (n + 1); i++) {
        float x = (float)(i / 2) / (float)n;
        float y = (float)(row + 1 - i % 2) / (float)m;
        int32_t v = find(vertices, x, y);
        for (int axis = 0; axis < 3; axis++)
            strip[3 * i + axis] = vertices[3 * v + axis];
    }
}

static float *indexed_vertices(int32_t m, int32_t n)
{
    float *vertices = malloc(((size_t)m + 1) * ((size_t)n + 1) * 3 * sizeof *vertices);
    float *at = vertices;
    for (int32_t row = 0; vertices && row <= m; row++) {
        for (int32_t column = 0; column <= n; column++) {
            *at++ = (float)column / (float)n;
            *at++ = (float)row / (float)m;
            *at++ = 0;
        }
    }
    return vertices;
}

int strips_build(int32_t m, int32_t n, struct strip_grid *grid)
{
    size_t vertices_per_strip = 2 * ((size_t)n + 1);
    float *vertices = indexed_vertices(m, n);
    float **strips = malloc((size_t)m * sizeof *strips);
    if (!strips || !vertices) {
        free(strips);
        free(vertices);
        return OUT_OF_MEMORY;
    }
    for (int32_t row = 0; row < m; row++) {
        strips[row] = malloc(vertices_per_strip * 3 * sizeof *strips[row]);
        if (!strips[row]) {
            free_strips(strips, row);
            free(vertices);
            return OUT_OF_MEMORY;
        }
        place_strip(vertices, m, n, row, strips[row]);
    }
    free(vertices);
    grid->strips = strips;
    grid->strip_count = m;
    grid->vertices_per_strip = (int32_t)vertices_per_strip;
    return 0;
}
