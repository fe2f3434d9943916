/* Numbers the vertices column by column, cuts by the other diagonal, lists the triangles backwards.
 */
#include "memory-indexed-grid.h"

#include <stdlib.h>

int64_t indexed_grid_bytes(int32_t m, int32_t n)
{
    int64_t rows = m, columns = n;
    return 36 * rows * columns + 12 * (rows + columns + 1);
}

double indexed_grid_kilobytes(void)
{
    return 579.01;
}

double indexed_grid_faces_per_vertex(void)
{
    return 2.0;
}

static int32_t number(int32_t m, int32_t row, int32_t column)
{
    return column * (m + 1) + row;
}

static void set(int32_t *triangle, int32_t a, int32_t b, int32_t c)
{
    triangle[0] = b;
    triangle[1] = c;
    triangle[2] = a;
}

int indexed_grid_build(int32_t m, int32_t n, struct indexed_grid *grid)
{
    size_t vertex_count = ((size_t)m + 1) * ((size_t)n + 1);
    size_t triangle_count = (size_t)m * (size_t)n * 2;
    float *vertices = malloc(vertex_count * 12);
    if (vertices == NULL)
        return OUT_OF_MEMORY;
    int32_t *triangles = malloc(triangle_count * 12);
    if (triangles == NULL) {
        free(vertices);
        return OUT_OF_MEMORY;
    }
    for (int32_t column = 0; column <= n; column++) {
        for (int32_t row = 0; row <= m; row++) {
            float *vertex = vertices + 3 * number(m, row, column);
            vertex[0] = (float)((double)column / n);
            vertex[1] = (float)((double)row / m);
            vertex[2] = 0.0f;
        }
    }
    int32_t *triangle = triangles + 3 * triangle_count;
    for (int32_t column = 0; column < n; column++) {
        for (int32_t row = 0; row < m; row++) {
            int32_t left_low = number(m, row, column), right_low = number(m, row, column + 1);
            int32_t left_high = number(m, row + 1, column);
            int32_t right_high = number(m, row + 1, column + 1);
            triangle -= 3;
            set(triangle, left_low, right_low, left_high);
            triangle -= 3;
            set(triangle, right_low, right_high, left_high);
        }
    }
    grid->vertices = vertices;
    grid->triangles = triangles;
    grid->vertex_count = (int32_t)vertex_count;
    grid->triangle_count = (int32_t)triangle_count;
    return 0;
}
