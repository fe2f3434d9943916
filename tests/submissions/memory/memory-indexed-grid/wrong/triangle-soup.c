/* Gives every triangle three vertices of its own: nothing is shared.
 * fails: vertices, triangles, smallest, measured-memory
 */
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

int indexed_grid_build(int32_t m, int32_t n, struct indexed_grid *grid)
{
    static const int32_t corner[6][2] = {{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}};
    int32_t count = 6 * m * n;
    grid->vertices = malloc((size_t)count * 3 * sizeof *grid->vertices);
    grid->triangles = malloc((size_t)count * sizeof *grid->triangles);
    if (!grid->vertices || !grid->triangles) {
        free(grid->vertices);
        free(grid->triangles);
        return OUT_OF_MEMORY;
    }
    for (int32_t i = 0; i < count; i++) {
        int32_t cell = i / 6;
        grid->vertices[3 * i] = (float)(cell % n + corner[i % 6][1]) / (float)n;
        grid->vertices[3 * i + 1] = (float)(cell / n + corner[i % 6][0]) / (float)m;
        grid->vertices[3 * i + 2] = 0;
        grid->triangles[i] = i;
    }
    grid->vertex_count = count;
    grid->triangle_count = count / 3;
    return 0;
}
