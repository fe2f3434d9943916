/* Problem 4.2: the grid as an indexed mesh, row by row. */
#include "memory-indexed-grid.h"

#include <stdlib.h>

static int64_t vertex_count_of(int64_t m, int64_t n)
{
    return (m + 1) * (n + 1);
}

static int64_t triangle_count_of(int64_t m, int64_t n)
{
    return 2 * m * n;
}

int64_t indexed_grid_bytes(int32_t m, int32_t n)
{
    return vertex_count_of(m, n) * 3 * (int64_t)sizeof(float) +
           triangle_count_of(m, n) * 3 * (int64_t)sizeof(int32_t);
}

double indexed_grid_kilobytes(void)
{
    return (double)indexed_grid_bytes(128, 128) / 1024;
}

double indexed_grid_faces_per_vertex(void)
{
    return 2; /* 2mn / ((m + 1)(n + 1)) */
}

static void place_vertices(int32_t m, int32_t n, float *vertices)
{
    float *at = vertices;
    for (int32_t row = 0; row <= m; row++) {
        float y = (float)row / (float)m;
        for (int32_t column = 0; column <= n; column++) {
            *at++ = (float)column / (float)n;
            *at++ = y;
            *at++ = 0;
        }
    }
}

static void join_vertices(int32_t m, int32_t n, int32_t *triangles)
{
    int32_t *at = triangles;
    for (int32_t row = 0; row < m; row++) {
        for (int32_t column = 0; column < n; column++) {
            int32_t low = row * (n + 1) + column;
            int32_t high = low + n + 1;
            *at++ = low;
            *at++ = low + 1;
            *at++ = high + 1;
            *at++ = low;
            *at++ = high + 1;
            *at++ = high;
        }
    }
}

int indexed_grid_build(int32_t m, int32_t n, struct indexed_grid *grid)
{
    int64_t vertex_count = vertex_count_of(m, n);
    int64_t triangle_count = triangle_count_of(m, n);
    grid->vertices = malloc((size_t)vertex_count * 3 * sizeof *grid->vertices);
    grid->triangles = malloc((size_t)triangle_count * 3 * sizeof *grid->triangles);
    if (!grid->vertices || !grid->triangles) {
        free(grid->vertices);
        free(grid->triangles);
        return OUT_OF_MEMORY;
    }
    grid->vertex_count = (int32_t)vertex_count;
    grid->triangle_count = (int32_t)triangle_count;
    place_vertices(m, n, grid->vertices);
    join_vertices(m, n, grid->triangles);
    return 0;
}
