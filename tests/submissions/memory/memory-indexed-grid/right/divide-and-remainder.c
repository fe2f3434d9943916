/* Two flat loops: place and corner follow from the number by division and remainder. */
#include "memory-indexed-grid.h"

#include <stdlib.h>

int64_t indexed_grid_bytes(int32_t m, int32_t n)
{
    return ((int64_t)m + 1) * ((int64_t)n + 1) * 3 * 4 + 2LL * m * n * 3 * 4;
}

double indexed_grid_kilobytes(void)
{
    return (129.0 * 129.0 * 12.0 + 128.0 * 128.0 * 24.0) / 1024.0;
}

double indexed_grid_faces_per_vertex(void)
{
    int64_t side = 1000000;
    return 2.0 * (double)(side * side) / (double)((side + 1) * (side + 1));
}

int indexed_grid_build(int32_t m, int32_t n, struct indexed_grid *grid)
{
    static const int32_t corner[2][3] = {{0, 1, 3}, {0, 3, 2}};
    int32_t across = n + 1;
    grid->vertex_count = (m + 1) * across;
    grid->triangle_count = 2 * m * n;
    grid->triangles = calloc((size_t)grid->triangle_count, 3 * sizeof(int32_t));
    grid->vertices = calloc((size_t)grid->vertex_count, 3 * sizeof(float));
    if (!grid->triangles || !grid->vertices) {
        free(grid->vertices);
        free(grid->triangles);
        return OUT_OF_MEMORY;
    }
    for (int32_t v = 0; v < grid->vertex_count; v++) {
        grid->vertices[3 * v] = (float)(v % across) / (float)n;
        grid->vertices[3 * v + 1] = (float)(v / across) / (float)m;
    }
    for (int32_t t = 0; t < grid->triangle_count; t++) {
        int32_t cell = t / 2;
        int32_t first = cell / n * across + cell % n;
        for (int i = 0; i < 3; i++) {
            int32_t k = corner[t % 2][i];
            grid->triangles[3 * t + i] = first + k % 2 + k / 2 * across;
        }
    }
    return 0;
}
