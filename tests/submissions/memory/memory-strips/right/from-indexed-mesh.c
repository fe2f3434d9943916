/* Makes the vertices of the indexed mesh first and copies each strip from it. */
#include "memory-strips.h"

#include <stdlib.h>
#include <string.h>

int64_t indexed_processed_vertices(int32_t m, int32_t n)
{
    int64_t rows = m, columns = n;
    return (rows + 1) * (columns + 1);
}

int64_t strips_processed_vertices(int32_t m, int32_t n)
{
    int64_t vertices_per_strip = 2;
    vertices_per_strip += 2 * (int64_t)n;
    return vertices_per_strip * m;
}

int64_t strips_bytes(int32_t m, int32_t n)
{
    return 4 + 8 * (int64_t)m + 12 * strips_processed_vertices(m, n);
}

double strips_kilobytes(void)
{
    return strips_bytes(128, 128) / 1024.0;
}

double strips_memory_ratio(void)
{
    double m = 1e9, n = 1e9;
    return (12 * (m + 1) * (n + 1) + 24 * m * n) / (4 + 8 * m + 24 * m * (n + 1));
}

double strips_time_ratio(void)
{
    return (double)strips_processed_vertices(100000000, 100000000) /
           (double)indexed_processed_vertices(100000000, 100000000);
}

static float *copy_strip(const float *vertices, int32_t n, int32_t row)
{
    size_t vertex_bytes = 3 * sizeof(float);
    float *strip = malloc(2 * (size_t)(n + 1) * vertex_bytes);
    for (int32_t column = 0; strip && column <= n; column++) {
        size_t low = (size_t)row * (size_t)(n + 1) + (size_t)column;
        size_t high = low + (size_t)(n + 1);
        memcpy(strip + 6 * (size_t)column, vertices + 3 * high, vertex_bytes);
        memcpy(strip + 6 * (size_t)column + 3, vertices + 3 * low, vertex_bytes);
    }
    return strip;
}

static int fill(const float *vertices, int32_t m, int32_t n, float **strips)
{
    for (int32_t row = 0; row < m; row++) {
        strips[row] = copy_strip(vertices, n, row);
        if (!strips[row]) {
            while (row-- > 0)
                free(strips[row]);
            return OUT_OF_MEMORY;
        }
    }
    return 0;
}

int strips_build(int32_t m, int32_t n, struct strip_grid *grid)
{
    int32_t vertex_count = (m + 1) * (n + 1);
    float *vertices = malloc((size_t)vertex_count * 3 * sizeof *vertices);
    float **strips = malloc((size_t)m * sizeof *strips);
    int status = OUT_OF_MEMORY;
    if (vertices && strips) {
        for (int32_t v = 0; v < vertex_count; v++) {
            vertices[3 * v] = (float)(v % (n + 1)) / (float)n;
            vertices[3 * v + 1] = (float)(v / (n + 1)) / (float)m;
            vertices[3 * v + 2] = 0;
        }
        status = fill(vertices, m, n, strips);
    }
    free(vertices);
    if (status != 0) {
        free(strips);
        return status;
    }
    *grid = (struct strip_grid){strips, m, 2 * (n + 1)};
    return 0;
}
