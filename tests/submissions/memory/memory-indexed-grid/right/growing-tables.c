/* Appends to tables that double with realloc, visits the cells as a chess board, and trims at the
 * end. */
#include "memory-indexed-grid.h"

#include <stdlib.h>

struct table {
    int32_t *values;
    size_t count, capacity;
};

int64_t indexed_grid_bytes(int32_t m, int32_t n)
{
    int64_t vertices = (int64_t)(m + 1) * (n + 1);
    int64_t faces = (int64_t)m * n * 2;
    return (int64_t)sizeof(float[3]) * vertices + (int64_t)sizeof(int32_t[3]) * faces;
}

double indexed_grid_kilobytes(void)
{
    return (double)indexed_grid_bytes(128, 128) / 1024.0;
}

double indexed_grid_faces_per_vertex(void)
{
    return 2;
}

static int append(struct table *table, int32_t a, int32_t b, int32_t c)
{
    if (table->count + 3 > table->capacity) {
        size_t capacity = table->capacity ? 2 * table->capacity : 24;
        int32_t *larger = realloc(table->values, capacity * sizeof *larger);
        if (!larger)
            return OUT_OF_MEMORY;
        table->values = larger;
        table->capacity = capacity;
    }
    table->values[table->count++] = a;
    table->values[table->count++] = b;
    table->values[table->count++] = c;
    return 0;
}

static int append_cell(struct table *table, int32_t n, int32_t row, int32_t column)
{
    int32_t a = row * (n + 1) + column, b = a + 1, c = a + n + 1, d = c + 1;
    if ((row + column) % 2 == 0)
        return append(table, a, b, d) || append(table, d, c, a);
    return append(table, b, c, a) || append(table, c, b, d);
}

int indexed_grid_build(int32_t m, int32_t n, struct indexed_grid *grid)
{
    struct table table = {0};
    for (int32_t row = 0; row < m; row++) {
        for (int32_t column = 0; column < n; column++) {
            if (append_cell(&table, n, row, column)) {
                free(table.values);
                return OUT_OF_MEMORY;
            }
        }
    }
    int32_t *trimmed = realloc(table.values, table.count * sizeof *trimmed);
    if (!trimmed) {
        free(table.values);
        return OUT_OF_MEMORY;
    }
    float *at = malloc((size_t)(m + 1) * (size_t)(n + 1) * 3 * sizeof *at);
    if (!at) {
        free(trimmed);
        return OUT_OF_MEMORY;
    }
    grid->vertices = at;
    grid->triangles = trimmed;
    grid->vertex_count = (m + 1) * (n + 1);
    grid->triangle_count = (int32_t)(table.count / 3);
    for (int32_t row = 0; row <= m; row++)
        for (int32_t column = 0; column <= n; column++, at += 3) {
            at[0] = (float)column / (float)n;
            at[1] = (float)row / (float)m;
            at[2] = 0;
        }
    return 0;
}
